// One parameter of one direction: clamped to the domain, its span, its basis row.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "knotfit/basis.h"
namespace knotfit {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

inline double clamp_to_domain(const KnotVector& knots, double x) {
  return std::clamp(x, knots.first(), knots.last());
}

using BasisRow = std::array<double, kMaxDegree + 1>;

/// The derivatives of one order, 0 the values. \return all zero above the degree
inline BasisRow basis_row(const KnotVector& knots, Index span, double x, int derivative) {
  BasisRow row{};
  if (derivative == 0) {
    basis_functions(knots, span, x, row);
  } else if (derivative <= knots.degree()) {
    std::array<double, (kMaxDegree + 1) * (kMaxDegree + 1)> all;
    basis_derivatives(knots, span, x, derivative, all);
    const int width = knots.degree() + 1;
    std::copy_n(all.begin() + derivative * width, width, row.begin());
  }
  return row;
}

}  // namespace knotfit
