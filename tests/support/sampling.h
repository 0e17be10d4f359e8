// Dense samples of splines, for distances that must hold everywhere.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "knotfit/evaluate.h"
namespace knotfit::test {

/// Every break and `per_span` parameters inside every span of the domain.
inline std::vector<double> dense_parameters(const KnotVector& knots, int per_span) {
  const std::vector<double> breaks = knots.breaks();
  std::vector<double> result;
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
    result.push_back(breaks[s]);
    for (int k = 1; k <= per_span; ++k)
      result.push_back(breaks[s] + (breaks[s + 1] - breaks[s]) * (k / (per_span + 1.0)));
    // The limit from the left, which a jump keeps apart.
    result.push_back(std::nextafter(breaks[s + 1], breaks[s]));
  }
  result.push_back(breaks.back());
  return result;
}

/// Largest sampled distance |a(u,v) - b(u,v)| of surfaces over the same domain.
inline double max_distance(const Surface& a, const Surface& b, int per_span = 3) {
  const std::vector<double> u = dense_parameters(a.knots_u(), per_span);
  const std::vector<double> v = dense_parameters(a.knots_v(), per_span);
  const std::vector<double> pa = evaluate_grid(a, u, v), pb = evaluate_grid(b, u, v);
  double largest = 0;
  for (std::size_t k = 0; k < pa.size(); k += static_cast<std::size_t>(a.dimension())) {
    double sum = 0;
    for (std::size_t d = k; d < k + static_cast<std::size_t>(a.dimension()); ++d)
      sum += (pa[d] - pb[d]) * (pa[d] - pb[d]);
    largest = std::max(largest, std::sqrt(sum));
  }
  return largest;
}

/// The error that evaluate.h promises at most, a component.
inline double evaluation_error(const Surface& s) {
  return (s.degree_u() + s.degree_v() + 2) * 4 * 0x1p-52 * s.scale();
}

}  // namespace knotfit::test
