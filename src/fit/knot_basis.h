// Basis functions at a place, and how they change with the knots [Piegl98].
#pragma once
#include <array>
#include <vector>

#include "solve/axis.h"
namespace knotfit {

/// One direction at one parameter. Of the arrays the first `width` and 2 degree entries count.
struct KnotBasis {
  Index span = 0;
  std::array<double, kMaxDegree + 1> value{};  ///< of the functions alive on the span
  /// Of the same functions, in interior knot span - degree + e: [e][i].
  std::array<std::array<double, kMaxDegree + 1>, 2 * kMaxDegree> by_knot{};

  /// \param derivatives  of knot_derivatives(axis); empty: `by_knot` is left as it is
  void set(const Axis& axis, const std::vector<double>& derivatives, double parameter);
};

}  // namespace knotfit
