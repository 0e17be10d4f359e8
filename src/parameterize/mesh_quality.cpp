#include "parameterize/mesh_quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "knotfit/errors.h"
#include "parameterize/mesh_orientation.h"
#include "parameterize/mesh_rest.h"
namespace knotfit {
namespace mesh_map {
namespace {

// Least angle between the images of two orthogonal directions: those halfway between the axes of
// singular values s1 >= s2, 2 atan(s2 / s1).
double least_angle(const Jacobian& j) {
  const double s1 = std::hypot(0.5 * (j.xu + j.yv), 0.5 * (j.yu - j.xv)) +
                    std::hypot(0.5 * (j.xu - j.yv), 0.5 * (j.yu + j.xv));
  return 2 * std::atan2(j.determinant() / s1, s1) * 180 / std::numbers::pi;
}

}  // namespace

MapQuality measure_quality(const DiskMesh& disk, std::span<const double> uv) {
  const std::vector<RestTriangle> rest = rest_triangles(disk, 0);
  const Stretch stretch = measure_stretch(disk, rest, uv);
  MapQuality quality;
  quality.stretch = stretch.square;
  quality.aspect_free_stretch = stretch.aspect_free;
  quality.aspect = stretch.aspect;
  quality.flipped = count_flipped(disk.face, uv);
  quality.worst_angle = 90;
  for (int f = 0; f < disk.face_count(); ++f) {
    if (disk.virtual_face[f]) continue;
    Jacobian j = jacobian(rest[f], disk.face[f], uv.data());
    j.xu *= stretch.aspect, j.xv *= stretch.aspect;
    quality.worst_angle = std::min(quality.worst_angle, j.determinant() > 0 ? least_angle(j) : 0.0);
  }
  return quality;
}

}  // namespace mesh_map

MapQuality measure_map(const Mesh& mesh, const std::vector<double>& uv) {
  if (static_cast<Index>(uv.size()) != 2 * mesh.vertex_count())
    throw InvalidInput(fmt::format("{} vertices need {} parameters, u and v each; there are {}",
                                   mesh.vertex_count(), 2 * mesh.vertex_count(), uv.size()));
  if (mesh.faces.empty()) throw InvalidInput("the mesh has no faces to measure a map on");
  for (std::size_t k = 0; k < uv.size(); ++k)
    if (!std::isfinite(uv[k]))
      throw InvalidInput(fmt::format("vertex {}: {} = {} is not finite", k / 2, k % 2 ? 'v' : 'u', uv[k]));
  return mesh_map::measure_quality(mesh_map::faces_alone(mesh), uv);
}

}  // namespace knotfit
