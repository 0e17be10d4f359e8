// Sums over the points of one cell whose weights are 3 x 3 matrices.
#pragma once
#include <span>
namespace knotfit::correction {

/// A point at local coordinates t (outer), s (inner) in [-1,1].
struct BlockPoint {
  double t, s;
  double matrix[6];  ///< w M: xx, xy, xz, yy, yz, zz
  double rhs[3];     ///< w M P
  double weight;     ///< w
};

/// Inner moments are padded to a multiple of 8.
inline int padded_moments(int count) {
  return (count + 7) / 8 * 8;
}

/// Adds matrix[c] P_a(t) P_b(s) to moments[(c * qo + a) * padded_moments(qi) + b] for c < parts, and
/// rhs[d] B_i(t) B_j(s) to right[(d * wo + i) * wi + j]; P Legendre, q = 2 degree + 1, w = degree + 1.
/// \param basis_outer, basis_inner  of Axis::basis
/// \return sum of w B_i^2 B_j^2
double add_block_moments(std::span<const BlockPoint> points, int degree_outer, int degree_inner,
                         const double* basis_outer, const double* basis_inner, int parts, double* moments,
                         double* right);

}  // namespace knotfit::correction
