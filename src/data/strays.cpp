#include "data/strays.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
namespace knotfit {

std::vector<Index> far_strays(std::span<const double> values, int dimension) {
  constexpr double kFar = 1000;
  const auto d = static_cast<std::size_t>(dimension);
  const std::size_t n = values.size() / d;
  if (n < 5) return {};
  std::vector<double> distance(n, 0.0), column(n);
  for (std::size_t c = 0; c < d; ++c) {
    for (std::size_t k = 0; k < n; ++k) column[k] = values[k * d + c];
    const auto middle = column.begin() + static_cast<std::ptrdiff_t>(n / 2);
    std::nth_element(column.begin(), middle, column.end());
    for (std::size_t k = 0; k < n; ++k) distance[k] = std::hypot(distance[k], values[k * d + c] - *middle);
  }
  const std::size_t most = std::max<std::size_t>(1, n / 20);
  // Hardly any data has strays: then the distances themselves, parted, say so.
  column = distance;
  const auto last = column.begin() + static_cast<std::ptrdiff_t>(most);
  std::nth_element(column.begin(), last, column.end(), std::greater<>());
  if (!(*std::max_element(column.begin(), last) >= kFar * *last)) return {};
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), Index{0});
  std::partial_sort(
      order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most + 1), order.end(),
      [&](Index a, Index b) { return distance[a] != distance[b] ? distance[a] > distance[b] : a < b; });
  std::size_t strays = 0;
  for (std::size_t k = 0; k < most; ++k)
    if (distance[order[k]] > 0 && distance[order[k]] >= kFar * distance[order[k + 1]] &&
        (d > 1 || distance[order[k + 1]] > 0))
      strays = k + 1;
  order.resize(strays);
  std::sort(order.begin(), order.end());
  return order;
}

}  // namespace knotfit
