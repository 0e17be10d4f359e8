// The basis recursions for one parameter (T = double) or several of one span side by side
// (T = Lanes). The public functions and the batches run this same code, and no operation mixes
// lanes, so that a parameter gives the same bits whatever its neighbours.
#pragma once
#include <algorithm>

#include "knotfit/knot_vector.h"
namespace knotfit {

/// Eight doubles, as a type that g++ and clang++ map to whatever vector registers there are.
inline constexpr int kLanes = 8;
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double))));

#define KNOTFIT_INLINE inline __attribute__((always_inline))

inline constexpr int kFunctions = kMaxDegree + 1;

/// [Piegl97 A2.2]. At a knot, a * (1 / a) would miss 1 by a rounding: the share is taken whole, so
/// that a surface meets its corner control points exactly.
/// \param t       at the span's first knot: t[1 - degree .. degree] are read
/// \param values  degree + 1 entries, written
template <class T>
KNOTFIT_INLINE void basis_values(const double* t, int degree, const T& x, T* values) {
  T left[kFunctions], right[kFunctions];
  values[0] = T{} + 1.0;
  for (int j = 1; j <= degree; ++j) {
    left[j] = x - t[1 - j];
    right[j] = t[j] - x;
    T saved{};
    for (int r = 0; r < j; ++r) {
      const T a = right[r + 1], b = left[j - r], whole = values[r], part = whole / (a + b);
      const T to_a = a * part, to_b = b * part;
      values[r] = saved + (b == 0.0 ? whole : to_a);
      saved = a == 0.0 ? whole : to_b;
    }
    values[j] = saved;
  }
}

/// [Piegl97 A2.3], its values those of basis_values to the bit.
/// \param values  (order + 1) x (degree + 1), written; order <= degree
template <class T>
KNOTFIT_INLINE void basis_rows(const double* t, int degree, const T& x, int order, T* values) {
  const int p = degree;
  T left[kFunctions], right[kFunctions];
  T ndu[kFunctions][kFunctions];  // functions of every degree above the diagonal, knot differences below
  ndu[0][0] = T{} + 1.0;
  for (int j = 1; j <= p; ++j) {
    left[j] = x - t[1 - j];
    right[j] = t[j] - x;
    T saved{};
    for (int r = 0; r < j; ++r) {
      const T a = right[r + 1], b = left[j - r], whole = ndu[r][j - 1];
      ndu[j][r] = a + b;
      const T part = whole / ndu[j][r], to_a = a * part, to_b = b * part;
      ndu[r][j] = saved + (b == 0.0 ? whole : to_a);
      saved = a == 0.0 ? whole : to_b;
    }
    ndu[j][j] = saved;
  }
  for (int j = 0; j <= p; ++j) values[j] = ndu[j][p];

  T coefficients[2][kFunctions];
  for (int r = 0; r <= p; ++r) {
    T *from = coefficients[0], *to = coefficients[1];
    from[0] = T{} + 1.0;
    double factor = p;  // p! / (p - k)!
    for (int k = 1; k <= order; ++k) {
      const int rk = r - k, pk = p - k;
      T d{};
      if (r >= k) {
        to[0] = from[0] / ndu[pk + 1][rk];
        d = to[0] * ndu[rk][pk];
      }
      const int j_first = rk >= -1 ? 1 : -rk;
      const int j_last = r - 1 <= pk ? k - 1 : p - r;
      for (int j = j_first; j <= j_last; ++j) {
        to[j] = (from[j] - from[j - 1]) / ndu[pk + 1][rk + j];
        d += to[j] * ndu[rk + j][pk];
      }
      if (r <= pk) {
        to[k] = -from[k - 1] / ndu[pk + 1][r];
        d += to[k] * ndu[r][pk];
      }
      values[k * (p + 1) + r] = d * factor;
      factor *= pk;
      std::swap(from, to);
    }
  }
}

}  // namespace knotfit
