#include "parameterize/mesh_quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "data/mesh_data.h"
#include "data/orientation.h"
#include "knotfit/exceptions.h"
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

namespace {

void check_map(const Mesh& mesh, const std::vector<double>& uv) {
  require_parameters(mesh, uv);
  if (mesh.faces.empty()) throw InvalidInput("the mesh has no faces to measure a map on");
  for (std::size_t k = 0; k < uv.size(); ++k)
    if (!std::isfinite(uv[k]))
      throw InvalidInput(fmt::format("vertex {}: {} = {} is not finite", k / 2, k % 2 ? 'v' : 'u', uv[k]));
}

}  // namespace

MapQuality measure_map(const Mesh& mesh, const std::vector<double>& uv) {
  check_map(mesh, uv);
  return mesh_map::measure_quality(mesh_map::faces_alone(mesh), uv);
}

std::vector<double> face_stretches(const Mesh& mesh, const std::vector<double>& uv, double aspect) {
  check_map(mesh, uv);
  if (!(aspect > 0) || !std::isfinite(aspect))
    throw InvalidInput(fmt::format("a rectangle of width over height {}: it must be positive", aspect));
  using namespace mesh_map;
  const DiskMesh disk = faces_alone(mesh);
  const std::vector<RestTriangle> rest = rest_triangles(disk, 0);
  std::vector<double> stretch(mesh.faces.size(), std::numeric_limits<double>::quiet_NaN());
  double area = 0, plane = 0;
  for (int f = 0; f < disk.face_count(); ++f) {
    const Jacobian j = jacobian(rest[f], disk.face[f], uv.data());
    const double d = j.determinant();
    if (!(d > 0)) continue;
    plane += d * rest[f].area;
    if (disk.virtual_face[f]) continue;
    area += rest[f].area;
    // |I e_u|^2 / aspect and |I e_v|^2 aspect of the inverse I of J, their mean.
    stretch[f] =
        0.5 * ((j.yv * j.yv + j.yu * j.yu) / aspect + (j.xv * j.xv + j.xu * j.xu) * aspect) / (d * d);
  }
  for (double& s : stretch) s = std::sqrt(s * plane / area);
  return stretch;
}

}  // namespace knotfit
