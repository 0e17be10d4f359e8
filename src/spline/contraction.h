// The sum over the control points of one cell. Every evaluation of a surface adds in this order
// (v inside, u outside), so that all of them give the same bits.
#pragma once
#include <cstring>

#include "knotfit/index.h"
namespace knotfit {

/// out_d = sum_a bu_a sum_b bv_b c_abd for one parameter (T = double) or several side by side
/// (T = Lanes of basis_lanes.h).
/// \param bu, bv  degree + 1 entries
/// \param net     the cell's first control point; a row of the net is `row` numbers
/// \param out     dimension x sizeof(T), written, of any alignment
template <class T>
inline __attribute__((always_inline)) void contract(const T* bu, int degree_u, const T* bv, int degree_v,
                                                    const double* net, Index row, int dimension,
                                                    double* out) {
  for (int d = 0; d < dimension; ++d) {
    T sum{};
    for (int a = 0; a <= degree_u; ++a) {
      const double* c = net + a * row + d;
      T inner{};
      for (int b = 0; b <= degree_v; ++b, c += dimension) inner += bv[b] * *c;
      sum += bu[a] * inner;
    }
    std::memcpy(out + d * static_cast<Index>(sizeof(T) / sizeof(double)), &sum, sizeof(T));
  }
}

}  // namespace knotfit
