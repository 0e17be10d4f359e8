// The energy that keeps cells without data alive [METHOD 1.2].
#pragma once
#include <algorithm>
#include <cstdlib>
#include <vector>

#include "solve/axis.h"
namespace knotfit {

/// Gram matrices of the derivatives of one direction, in the band storage of Axis::gram.
/// Degree 1 has no second derivative: both directions then use the membrane energy.
struct EnergyGrams {
  std::vector<double> value, first, second;
  int width;
  explicit EnergyGrams(const Axis& axis)
      : value(axis.gram(0)), first(axis.gram(1)), second(axis.gram(2)), width(axis.width()) {}
};

inline bool membrane(const EnergyGrams& a, const EnergyGrams& b) {
  return a.width == 2 || b.width == 2;
}

/// Entry of J: int |S_uu|^2 + 2 |S_uv|^2 + |S_vv|^2, or |S_u|^2 + |S_v|^2, at band entries g of a, h of b.
/// \param p, q  by which a second derivative along a, b counts: 1 / width^2 of the rectangle the energy is taken on
inline double energy_entry(const EnergyGrams& a, const EnergyGrams& b, Index g, Index h, double p = 1,
                           double q = 1) {
  return membrane(a, b) ? p * a.first[g] * b.value[h] + q * a.value[g] * b.first[h]
                        : p * p * a.second[g] * b.value[h] + 2 * p * q * a.first[g] * b.first[h] +
                              q * q * a.value[g] * b.second[h];
}

/// Calls visit(row, column, entry of J) once for each entry of the lower half that may not be zero, functions of a outside.
/// \param p, q  as of energy_entry()
template <class Visit>
void each_energy_entry(const EnergyGrams& a, const EnergyGrams& b, const Visit& visit, double p = 1,
                       double q = 1) {
  const Index rows = static_cast<Index>(a.value.size()) / a.width,
              columns = static_cast<Index>(b.value.size()) / b.width;
  for (Index i = 0; i < rows; ++i)
    for (Index k = 0; k < std::min<Index>(a.width, i + 1); ++k)
      for (Index j = 0; j < columns; ++j)
        for (Index l = std::max<Index>(0, j - b.width + 1); l < std::min(columns, j + b.width); ++l) {
          if (k == 0 && l > j) continue;
          const Index h = std::max(j, l) * b.width + std::abs(j - l);
          visit(i * columns + j, (i - k) * columns + l, energy_entry(a, b, i * a.width + k, h, p, q));
        }
}

inline double energy_trace(const EnergyGrams& a, const EnergyGrams& b) {
  auto trace = [](const std::vector<double>& g, int width) {
    double sum = 0;
    for (std::size_t i = 0; i < g.size(); i += width) sum += g[i];
    return sum;
  };
  const double a0 = trace(a.value, a.width), a1 = trace(a.first, a.width), a2 = trace(a.second, a.width);
  const double b0 = trace(b.value, b.width), b1 = trace(b.first, b.width), b2 = trace(b.second, b.width);
  return membrane(a, b) ? a1 * b0 + a0 * b1 : a2 * b0 + 2 * a1 * b1 + a0 * b2;
}

}  // namespace knotfit
