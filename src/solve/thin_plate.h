// The energy that keeps cells without data alive [METHOD 1.2].
#pragma once
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
inline double energy_entry(const EnergyGrams& a, const EnergyGrams& b, Index g, Index h) {
  return membrane(a, b) ? a.first[g] * b.value[h] + a.value[g] * b.first[h]
                        : a.second[g] * b.value[h] + 2 * a.first[g] * b.first[h] + a.value[g] * b.second[h];
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
