// Triangles at rest in a metric of positions and normals, and what a map does to them.
#pragma once
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "parameterize/mesh_disk.h"
namespace knotfit::mesh_map {

/// A triangle laid flat: gradients of its three hat functions, so that the Jacobian of a map is
/// J = sum_k p_k g_k^T.
struct RestTriangle {
  double area = 0;
  double gx[3] = {}, gy[3] = {};
  double length[3] = {};  ///< of the side opposite each corner
};

/// Rest triangles with l_ij^2 = |x_i - x_j|^2 + omega^2 |n_i - n_j|^2 over a diagonal of 1 [Lai06].
/// omega = 0: the triangles as they are.
std::vector<RestTriangle> rest_triangles(const DiskMesh& disk, double omega);

struct Jacobian {
  double xu, xv, yu, yv;  ///< d(x, y) of the plane by (u, v) of the rest frame, row by row
  double determinant() const { return xu * yv - xv * yu; }
  double squared_norm() const { return xu * xu + xv * xv + yu * yu + yv * yv; }
};
inline Jacobian jacobian(const RestTriangle& rest, const Face& t, const double* uv) {
  Jacobian j{0, 0, 0, 0};
  for (int k = 0; k < 3; ++k) {
    const double x = uv[2 * t[k]], y = uv[2 * t[k] + 1];
    j.xu += x * rest.gx[k], j.xv += x * rest.gy[k];
    j.yu += y * rest.gx[k], j.yv += y * rest.gy[k];
  }
  return j;
}

/// How a map onto the unit square stretches; virtual faces do not count [METHOD 7.1].
struct Stretch {
  double square = 0;       ///< L2 on the square [Sander01]; 1: isometric
  double aspect_free = 0;  ///< L2 on the best rectangle
  double aspect = 1;       ///< width over height of that rectangle
  bool flat = false;       ///< some triangle has no area or is turned over; it is left out
  /// What searches bring down: infinite where a triangle is flat.
  double cost() const { return flat ? std::numeric_limits<double>::infinity() : aspect_free; }
};
Stretch measure_stretch(const DiskMesh& disk, const std::vector<RestTriangle>& rest,
                        std::span<const double> uv);

/// Root mean square stretch of the triangles at each vertex on the rectangle of that aspect.
std::vector<double> vertex_stretch(const DiskMesh& disk, const std::vector<RestTriangle>& rest,
                                   std::span<const double> uv, double aspect);

}  // namespace knotfit::mesh_map
