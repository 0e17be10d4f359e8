// The basis recursion for W parameters of one span side by side. The public functions and the
// batches run this same code, so that a lane gives the same bits whatever its neighbours.
#pragma once
#include "knotfit/knot_vector.h"
namespace knotfit {

/// [Piegl97 A2.2]. At a knot, a * (1 / a) would miss 1 by a rounding: the share is taken whole, so
/// that a surface meets its corner control points exactly.
/// \param t       at the span's first knot: t[1 - degree .. degree] are read
/// \param x       W parameters
/// \param values  (degree + 1) x W, written
template <int W>
inline void basis_lanes(const double* t, int degree, const double* x, double* values) {
  double left[kMaxDegree + 1][W], right[kMaxDegree + 1][W];
  for (int l = 0; l < W; ++l) values[l] = 1;
  for (int j = 1; j <= degree; ++j) {
    double saved[W];
    for (int l = 0; l < W; ++l) {
      left[j][l] = x[l] - t[1 - j];
      right[j][l] = t[j] - x[l];
      saved[l] = 0;
    }
    for (int r = 0; r < j; ++r) {
      double* value = values + r * W;
      const double *a = right[r + 1], *b = left[j - r];
      for (int l = 0; l < W; ++l) {
        const double whole = value[l], part = whole / (a[l] + b[l]);
        const double to_a = a[l] * part, to_b = b[l] * part;
        value[l] = saved[l] + (b[l] == 0 ? whole : to_a);
        saved[l] = a[l] == 0 ? whole : to_b;
      }
    }
    for (int l = 0; l < W; ++l) values[j * W + l] = saved[l];
  }
}

}  // namespace knotfit
