#include "report/surface_shading.h"

#include <array>
#include <cmath>
#include <numbers>

#include "report/pixels.h"
namespace knotfit::report {
namespace {

bool in_stripe(double along, double stripe, double share) {
  return along - std::floor(along / stripe) * stripe < share * stripe;
}

/// Every other of equal angles of the mirrored line of sight about the camera's right: light. [Klass80]
double lamp(const Vec3& normal, const Vec3& eye, const Camera& camera) {
  constexpr double apart = std::numbers::pi / 18;
  const Vec3 mirrored = 2 * dot(normal, eye) * normal - eye;
  const double turn = std::atan2(dot(mirrored, camera.up), dot(mirrored, camera.toward)) / apart;
  return turn - std::floor(turn) < 0.5 ? 1.0 : 0.25;
}

}  // namespace

double brightness(const Vec3& n, const Camera& camera) {
  const Vec3 key = unit_or(-0.62 * camera.right + 0.55 * camera.up + 0.56 * camera.toward, camera.toward);
  const double wrapped = std::max(0.0, (dot(n, key) + 0.25) / 1.25);
  const double sky = 0.5 + 0.5 * dot(n, camera.up);
  return std::min(1.06, 0.50 + 0.49 * wrapped + 0.09 * sky);
}

SurfaceMesh make_mesh(const SurfaceSamples& s, double base) {
  SurfaceMesh mesh;
  mesh.position = s.position;
  const auto nu = static_cast<std::int32_t>(s.size_u()), nv = static_cast<std::int32_t>(s.size_v());
  mesh.triangles.reserve(2 * static_cast<std::size_t>(nu) * static_cast<std::size_t>(nv));
  for (std::int32_t i = 0; i + 1 < nu; ++i)
    for (std::int32_t j = 0; j + 1 < nv; ++j) {
      const std::int32_t a = i * nv + j;
      if (!s.kept[a] || !s.kept[a + nv] || !s.kept[a + 1] || !s.kept[a + nv + 1]) continue;
      mesh.triangles.push_back({a, a + nv, a + nv + 1});
      mesh.triangles.push_back({a, a + nv + 1, a + 1});
    }
  mesh.surface_triangles = static_cast<Index>(mesh.triangles.size());
  if (!s.height_field) return mesh;
  auto wall = [&](std::int32_t first, std::int32_t step, std::int32_t count) {
    const auto foot = static_cast<std::int32_t>(mesh.position.size());
    for (std::int32_t k = 0; k < count; ++k) {
      Vec3 p = s.position[static_cast<std::size_t>(first + k * step)];
      p.z = base;
      mesh.position.push_back(p);
    }
    for (std::int32_t k = 0; k + 1 < count; ++k) {
      const std::int32_t a = first + k * step;
      if (!s.kept[a] || !s.kept[a + step]) continue;
      mesh.triangles.push_back({a, a + step, foot + k + 1});
      mesh.triangles.push_back({a, foot + k + 1, foot + k});
    }
  };
  wall(0, nv, nu);
  wall(nv - 1, nv, nu);
  wall(0, 1, nv);
  wall((nu - 1) * nv, 1, nv);
  return mesh;
}

Image shade(const Content& content, const SurfaceMesh& mesh, const ZBuffer& buffer,
            const std::vector<ScreenPoint>& corners, const Camera& camera, int finer, double stripe) {
  const SurfaceSamples& s = content.samples;
  const Index nv = s.size_v();
  auto pixel = [&](int x, int y) -> std::optional<Rgb> {
    const std::int32_t id = buffer.triangle(x, y);
    if (id < 0) return std::nullopt;
    const Triangle& t = mesh.triangles[id];
    const std::array<double, 3> w = weights_at(corners[t[0]], corners[t[1]], corners[t[2]], x + 0.5, y + 0.5);
    const Vec3 face =
        unit_or(cross(mesh.position[t[1]] - mesh.position[t[0]], mesh.position[t[2]] - mesh.position[t[0]]),
                {0, 0, 1});
    const Vec3 eye = unit_or(camera.distance * camera.toward - mesh.position[t[0]], camera.toward);
    if (id >= mesh.surface_triangles) {
      // Walls say nothing: light, only their two directions told apart.
      const double b = 0.62 + 0.38 * brightness(dot(face, eye) < 0 ? -1.0 * face : face, camera);
      return Rgb{0.80 * b, 0.81 * b, 0.83 * b};
    }
    double u = 0, v = 0, z = 0;
    Vec3 normal;
    for (int k = 0; k < 3; ++k) {
      u += w[k] * s.u[t[k] / nv];
      v += w[k] * s.v[t[k] % nv];
      z += w[k] * s.position[t[k]].z;
      normal = normal + w[k] * s.normal[t[k]];
    }
    normal = unit_or(normal, face);
    const bool back = dot(face, eye) < 0;
    if (dot(normal, face) < 0) normal = -1.0 * normal;
    if (back) normal = -1.0 * normal;
    if (content.input->reflections) {
      const double b = lamp(normal, eye, camera) * brightness(normal, camera);
      return Rgb{0.93 * b, 0.95 * b, 0.98 * b};
    }
    const double height = s.scale.z > 0 ? s.centre.z + z / s.scale.z : s.centre.z;
    const std::optional<Rgb> own = content.colour_at(u, v, height);
    Rgb colour = own.value_or(kNoData);
    const bool thin = content.thin.ratio(u, v) < 1;
    if (!own && !thin && in_stripe(x - y, stripe, 0.3)) colour = mix(colour, {1, 1, 1}, 0.65);
    if (thin && in_stripe(x + y, stripe, 0.24)) colour = mix(colour, kInk, 0.6);
    const double b = brightness(normal, camera);
    return Rgb{std::min(1.0, colour.r * b), std::min(1.0, colour.g * b), std::min(1.0, colour.b * b)};
  };

  return averaged_pixels(buffer.width() / finer, buffer.height() / finer, finer, pixel);
}

}  // namespace knotfit::report
