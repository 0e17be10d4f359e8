// The smoothing floor, raised where rounding beats it [METHOD 1.2].
#pragma once
#include <algorithm>
namespace knotfit {

/// Calls attempt(floor) with `smoothing` and, while that fails, with a hundred times more, but no less than `second`,
/// up to 1e-5. A smoothing beyond 1e-5 is tried once.
/// \param smoothing  relative: lambda tr(J) / tr(A^T W A), >= 0
/// \param attempt    factors and solves with that floor. \return whether that succeeded
/// \param second     the smallest floor of the second attempt
/// \return whether an attempt succeeded
template <class Attempt>
bool with_smoothing_floor(double smoothing, const Attempt& attempt, double second = 1e-12) {
  const double most = std::max(smoothing, 1e-5);
  for (double floor = smoothing; floor <= most; floor = std::max(100 * floor, second))
    if (attempt(floor)) return true;
  return false;
}

}  // namespace knotfit
