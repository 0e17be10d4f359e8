// The middle of numbers.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace knotfit {

/// The greater of the two in the middle, where their number is even. \param x  not empty
inline double median(std::vector<double> x) {
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  return *middle;
}

}  // namespace knotfit
