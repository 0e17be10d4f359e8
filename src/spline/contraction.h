// The sum over the control points of one cell. Every evaluation of a surface adds in this order
// (v inside, u outside), so that all of them give the same bits.
#pragma once
#include "knotfit/index.h"
namespace knotfit {

/// out_d = sum_a bu_a sum_b bv_b c_abd for W parameters side by side.
/// \param bu, bv  (degree + 1) x W
/// \param net     the cell's first control point; a row of the net is `row` numbers
/// \param out     dimension x W, written
template <int W>
inline void contract(const double* bu, int degree_u, const double* bv, int degree_v, const double* net,
                     Index row, int dimension, double* out) {
  for (int d = 0; d < dimension; ++d) {
    double sum[W] = {};
    for (int a = 0; a <= degree_u; ++a) {
      const double* c = net + a * row + d;
      double inner[W] = {};
      for (int b = 0; b <= degree_v; ++b, c += dimension)
        for (int l = 0; l < W; ++l) inner[l] += bv[b * W + l] * *c;
      for (int l = 0; l < W; ++l) sum[l] += bu[a * W + l] * inner[l];
    }
    for (int l = 0; l < W; ++l) out[d * W + l] = sum[l];
  }
}

}  // namespace knotfit
