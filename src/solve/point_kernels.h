// The loops over points. One .cpp with a reference in tests/solve: each kernel takes one piece of one
// cell. Legendre counts are compile-time for equal degrees 1 to 5 and run-time otherwise.
#pragma once
#include "solve/cell_order.h"
#include "solve/normal_system.h"
namespace knotfit {

/// Inner moments are padded to a multiple of 4 doubles.
inline int padded(int count) {
  return (count + 3) / 4 * 4;
}

/// Adds w P_a(t) P_b(s) to matrix[a * padded(qi) + b] for a < qo, b < qi (qo, qi = Axis::moments())
/// and w x_e P_a(t) P_b(s) to rhs[(e * wo + a) * wi + b], a < wo, b < wi, x the points' values.
void add_moments(const CellOrder& order, const CellPiece& piece, int degree_outer, int degree_inner,
                 double* matrix, double* rhs);

/// The right-hand side alone, for values x (stored order, n x dimension).
void add_rhs_moments(const CellOrder& order, const CellPiece& piece, int degree_outer, int degree_inner,
                     const double* x, double* rhs);

/// x[e] of each point (stored order) = sum_ab c[(e * wo + a) * wi + b] P_a(t) P_b(s) - value, for the piece.
/// \param counted  input indices below it count in `squares` and `max` of the sums
/// \return their sums, `max` squared
ResidualSums set_residuals(const CellOrder& order, const CellPiece& piece, int degree_outer, int degree_inner,
                           Index counted, const double* c, double* x);

}  // namespace knotfit
