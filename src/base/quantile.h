// Which of sorted numbers a quantile is.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
namespace knotfit {

/// Position, in sorted order, of the least of n numbers that at least `share` of them do not pass.
/// \param n  >= 1   \param share  in (0, 1]
inline std::size_t quantile_position(std::size_t n, double share) {
  // Rounding of share * n must not ask for one number more than the share does.
  const double rank = std::ceil(share * static_cast<double>(n) * (1 - 1e-12));
  return std::clamp<std::size_t>(static_cast<std::size_t>(rank), 1, n) - 1;
}

}  // namespace knotfit
