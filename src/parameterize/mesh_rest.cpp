#include "parameterize/mesh_rest.h"

#include <algorithm>
#include <cmath>
namespace knotfit::mesh_map {
namespace {

double squared_distance(const Position& a, const Position& b) {
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

// |I e_u|^2 and |I e_v|^2 of the inverse I of J.
struct InverseColumns {
  double u, v;
};
InverseColumns inverse_columns(const Jacobian& j, double determinant) {
  const double d2 = determinant * determinant;
  return {(j.yv * j.yv + j.yu * j.yu) / d2, (j.xv * j.xv + j.xu * j.xu) / d2};
}

}  // namespace

std::vector<RestTriangle> rest_triangles(const DiskMesh& disk, double omega) {
  std::vector<RestTriangle> rest(disk.face.size());
  for (int f = 0; f < disk.face_count(); ++f) {
    RestTriangle& r = rest[f];
    double l2[3];
    for (int k = 0; k < 3; ++k) {
      const int a = disk.face[f][(k + 1) % 3], b = disk.face[f][(k + 2) % 3];
      l2[k] = squared_distance(disk.position[a], disk.position[b]) +
              omega * omega * squared_distance(disk.normal[a], disk.normal[b]);
      l2[k] = std::max(l2[k], 1e-20);
      r.length[k] = std::sqrt(l2[k]);
    }
    const double base = r.length[2], x = (l2[2] + l2[1] - l2[0]) / (2 * base);
    // A needle keeps a sliver of height: its Jacobian stays finite.
    const double y = std::sqrt(std::max(l2[1] - x * x, 1e-8 * l2[1]));
    r.area = 0.5 * base * y;
    const double px[3] = {0, base, x}, py[3] = {0, 0, y};
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      r.gx[k] = -(py[b] - py[a]) / (2 * r.area);
      r.gy[k] = (px[b] - px[a]) / (2 * r.area);
    }
  }
  return rest;
}

Stretch measure_stretch(const DiskMesh& disk, const std::vector<RestTriangle>& rest,
                        std::span<const double> uv) {
  double e = 0, g = 0, area = 0, plane = 0;
  Stretch stretch;
  for (int f = 0; f < disk.face_count(); ++f) {
    const Jacobian j = jacobian(rest[f], disk.face[f], uv.data());
    const double determinant = j.determinant();
    if (!(determinant > 0)) {
      stretch.flat = true;
      continue;
    }
    plane += determinant * rest[f].area;
    if (disk.virtual_face[f]) continue;
    const InverseColumns i = inverse_columns(j, determinant);
    e += rest[f].area * i.u;
    g += rest[f].area * i.v;
    area += rest[f].area;
  }
  const double norm = plane / (area * area);
  stretch.square = std::sqrt(0.5 * (e + g) * norm);
  stretch.aspect_free = std::sqrt(std::sqrt(e) * std::sqrt(g) * norm);
  stretch.aspect = e > 0 && g > 0 ? std::sqrt(e / g) : 1.0;
  if (!std::isfinite(stretch.aspect) || stretch.aspect <= 0) stretch.aspect = 1;
  if (!std::isfinite(stretch.square)) stretch.flat = true;
  return stretch;
}

std::vector<double> vertex_stretch(const DiskMesh& disk, const std::vector<RestTriangle>& rest,
                                   std::span<const double> uv, double aspect) {
  std::vector<double> energy(disk.position.size(), 0), area(disk.position.size(), 0);
  for (int f = 0; f < disk.face_count(); ++f) {
    const Jacobian j = jacobian(rest[f], disk.face[f], uv.data());
    const InverseColumns i = inverse_columns(j, j.determinant());
    const double e = 0.5 * rest[f].area * (i.u / aspect + i.v * aspect);
    for (const int v : disk.face[f]) {
      energy[v] += e;
      area[v] += rest[f].area;
    }
  }
  for (std::size_t v = 0; v < energy.size(); ++v) energy[v] = std::sqrt(energy[v] / area[v]);
  return energy;
}

}  // namespace knotfit::mesh_map
