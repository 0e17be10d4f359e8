#include "report/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "report/z_buffer.h"
namespace knotfit::report {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr Index kCoarse = 90;  // cells a direction to compare views by

// Eigenvector of the least eigenvalue of a symmetric 3 x 3 matrix (Jacobi rotations).
Vec3 thinnest_axis(std::array<std::array<double, 3>, 3> a) {
  std::array<std::array<double, 3>, 3> q{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < 20; ++sweep)
    for (int i = 0; i < 2; ++i)
      for (int j = i + 1; j < 3; ++j) {
        if (a[i][j] == 0) continue;
        const double angle = 0.5 * std::atan2(2 * a[i][j], a[j][j] - a[i][i]);
        const double c = std::cos(angle), s = std::sin(angle);
        for (int k = 0; k < 3; ++k) {
          const double x = a[k][i], y = a[k][j];
          a[k][i] = c * x - s * y;
          a[k][j] = s * x + c * y;
        }
        for (int k = 0; k < 3; ++k) {
          const double x = a[i][k], y = a[j][k];
          a[i][k] = c * x - s * y;
          a[j][k] = s * x + c * y;
          const double qx = q[k][i], qy = q[k][j];
          q[k][i] = c * qx - s * qy;
          q[k][j] = s * qx + c * qy;
        }
      }
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (a[k][k] < a[least][least]) least = k;
  return unit_or({q[0][least], q[1][least], q[2][least]}, {0, 0, 1});
}

struct Shape {
  Vec3 facing;           // unit, the side to look from
  double agreement = 0;  // |mean normal|, 1: flat, 0: closed
};

Shape shape_of(const ViewScene& s) {
  double total = 0, rim_total = 0;
  Vec3 normal, mean, rim;
  for (std::size_t k = 0; k < s.position.size(); ++k) {
    const double weight = s.area[k];
    total += weight;
    normal = normal + weight * s.normal[k];
    mean = mean + weight * s.position[k];
    if (!(weight > 0) || !s.rim[k]) continue;
    rim = rim + s.position[k];
    rim_total += 1;
  }
  if (!(total > 0) || rim_total == 0) return {{0, 0, 1}, 0};
  mean = (1 / total) * mean;
  rim = (1 / rim_total) * rim;
  Shape shape;
  shape.agreement = length(normal) / total;
  if (shape.agreement > 0.15) {
    shape.facing = unit_or(normal, {0, 0, 1});
  } else {
    std::array<std::array<double, 3>, 3> c{};
    for (std::size_t k = 0; k < s.position.size(); ++k) {
      const Vec3 d = s.position[k] - mean;
      const double x[3] = {d.x, d.y, d.z};
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) c[a][b] += s.area[k] * x[a] * x[b];
    }
    shape.facing = thinnest_axis(c);
  }
  const Vec3 f = shape.facing;
  if (std::abs(f.y) > 0.7) {
    // A landscape with y up, unless its peaks clearly point down.
    double above = 0, below = 0;
    for (std::size_t k = 0; k < s.position.size(); ++k) {
      if (!(s.area[k] > 0)) continue;
      above = std::max(above, s.position[k].y - rim.y);
      below = std::max(below, rim.y - s.position[k].y);
    }
    const double up = below > 2 * above ? -1 : 1;
    shape.facing = (f.y * up > 0 ? 1.0 : -1.0) * f;
    return shape;
  }
  // The side that bulges far out of the rim is the outside; else the top or the front is shown.
  const double bulge = dot(mean - rim, f);
  const double toward_top = std::abs(f.z) > 0.5 ? f.z : -f.y - 0.5 * f.x;
  if (std::abs(bulge) > 0.15 ? bulge < 0 : toward_top < 0) shape.facing = -1.0 * f;
  return shape;
}

// Every grid line counts, since a triangle's corners stand for cells of different size.
ViewScene whole_scene(const SurfaceSamples& s) {
  ViewScene scene;
  scene.position = s.position;
  scene.normal = s.normal;
  scene.area.resize(s.area.size());
  scene.rim.resize(s.area.size());
  scene.low = s.scene_low();
  scene.high = s.scene_high();
  const Index nu = s.size_u(), nv = s.size_v();
  auto width = [](const std::vector<double>& t, Index k) {
    const Index last = static_cast<Index>(t.size()) - 1;
    return (t[std::min(k + 1, last)] - t[std::max<Index>(k - 1, 0)]) / 2;
  };
  for (Index i = 0; i < nu; ++i)
    for (Index j = 0; j < nv; ++j) {
      const Index k = s.at(i, j);
      scene.area[k] = s.area[k] * width(s.u, i) * width(s.v, j);
      scene.rim[k] = i == 0 || j == 0 || i == nu - 1 || j == nv - 1;
    }
  return scene;
}

// A coarse grid is enough to compare views.
ViewScene coarse_scene(const SurfaceSamples& s) {
  std::vector<Index> rows, columns;
  auto pick = [](Index n, std::vector<Index>& out) {
    const Index steps = std::min(n - 1, kCoarse);
    for (Index k = 0; k <= steps; ++k) out.push_back(k * (n - 1) / steps);
  };
  pick(s.size_u(), rows);
  pick(s.size_v(), columns);
  ViewScene scene;
  std::vector<char> kept;
  const std::int32_t nv = static_cast<std::int32_t>(columns.size());
  for (Index i : rows)
    for (Index j : columns) {
      scene.position.push_back(s.position[s.at(i, j)]);
      scene.area.push_back(s.area[s.at(i, j)]);
      kept.push_back(s.kept[s.at(i, j)]);
    }
  for (std::int32_t i = 0; i + 1 < static_cast<std::int32_t>(rows.size()); ++i)
    for (std::int32_t j = 0; j + 1 < nv; ++j) {
      const std::int32_t a = i * nv + j;
      if (!kept[a] || !kept[a + nv] || !kept[a + 1] || !kept[a + nv + 1]) continue;
      scene.triangles.push_back({a, a + nv, a + nv + 1});
      scene.triangles.push_back({a, a + nv + 1, a + 1});
    }
  return scene;
}

Camera view_in_space(const ViewScene& whole, const ViewScene& coarse) {
  const Vec3 f = shape_of(whole).facing;
  // Upright: z where the surface stands; a sheet facing z shows y up; one facing y is a landscape
  // with y up.
  struct Candidate {
    Vec3 toward, upright;
    double liking;
  };
  std::vector<Candidate> candidates;
  const bool faces_z = std::abs(f.z) > 0.7, faces_y = std::abs(f.y) > 0.7;
  if (faces_y) {
    const Vec3 upright{0, f.y > 0 ? 1.0 : -1.0, 0};
    for (double azimuth : {32.0, -32.0, 148.0, -148.0})
      for (double elevation : {42.0, 55.0}) {
        const double a = azimuth * kDegree, e = elevation * kDegree;
        const Vec3 flat{-std::sin(a), 0, std::cos(a)};
        candidates.push_back({std::cos(e) * flat + std::sin(e) * upright, upright,
                              (std::abs(azimuth) < 90 ? 0.02 : 0) + (elevation < 50 ? 0.03 : 0)});
      }
  } else {
    const Vec3 upright = faces_z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 side = unit_or(cross(upright, f), {1, 0, 0});
    const Vec3 over = cross(f, side);
    // A flat sheet facing z may be a landscape: it is seen from the south. A deep one (a face) and
    // what stands upright are seen from a little above.
    const Vec3 low = whole.low, high = whole.high;
    const bool landscape = faces_z && high.z - low.z < 0.4 * std::min(high.x - low.x, high.y - low.y);
    for (double tilt : landscape ? std::array{45.0, 32.0} : std::array{30.0, 20.0})
      for (double turn :
           landscape ? std::array{-120.0, -60.0, -155.0, -25.0} : std::array{155.0, 25.0, 180.0, 0.0}) {
        const double a = turn * kDegree, t = tilt * kDegree;
        const Vec3 off = std::cos(a) * side + std::sin(a) * over;
        candidates.push_back({std::cos(t) * f + std::sin(t) * off, upright, tilt > 28 ? 0.02 : 0.0});
      }
  }
  Camera best;
  double best_score = -1;
  for (const Candidate& c : candidates) {
    const Camera camera = look_from(c.toward, c.upright);
    const double score = visible_share(coarse, camera) + c.liking;
    if (score > best_score + 1e-9) {
      best_score = score;
      best = camera;
    }
  }
  return best;
}

}  // namespace

Camera look_from(const Vec3& toward, const Vec3& upright) {
  Camera camera;
  camera.toward = unit_or(toward, {0, 0, 1});
  const Vec3 other = std::abs(camera.toward.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  Vec3 right = cross(upright, camera.toward);
  if (!(length(right) > 1e-6)) right = cross(other, camera.toward);
  camera.right = unit_or(right, {1, 0, 0});
  camera.up = cross(camera.toward, camera.right);
  return camera;
}

double visible_share(const ViewScene& scene, const Camera& view) {
  constexpr int kPixels = 220;
  Camera camera = view;
  camera.zoom = kPixels / 2.6;
  camera.origin = {kPixels / 2.0, kPixels / 2.0};
  std::vector<ScreenPoint> corners;
  corners.reserve(scene.position.size());
  for (const Vec3& p : scene.position) corners.push_back(camera.project(p));
  const ZBuffer buffer(kPixels, kPixels, corners, scene.triangles);
  double seen = 0, total = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    total += scene.area[k];
    if (buffer.visible(corners[k], 1.5e-4)) seen += scene.area[k];
  }
  return total > 0 ? seen / total : 1;
}

double visible_share(const SurfaceSamples& s, const Camera& camera) {
  return visible_share(coarse_scene(s), camera);
}

Camera choose_view(const SurfaceSamples& s) {
  if (s.height_field) {
    constexpr double kAzimuth = 32 * kDegree;  // west of south
    Camera camera;
    for (double elevation : {35.0, 40.0, 45.0}) {
      const double e = elevation * kDegree;
      camera = look_from({-std::sin(kAzimuth) * std::cos(e), -std::cos(kAzimuth) * std::cos(e), std::sin(e)},
                         {0, 0, 1});
      if (visible_share(s, camera) > 0.98) break;
    }
    return camera;
  }
  return view_in_space(whole_scene(s), coarse_scene(s));
}

Camera choose_view(const ViewScene& scene) {
  return view_in_space(scene, scene);
}

}  // namespace knotfit::report
