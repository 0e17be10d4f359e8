#include "place/row_knots.h"

#include <algorithm>
#include <numeric>

#include "place/shares.h"
namespace knotfit {
namespace {

void settle(std::vector<double>& knots, int count) {
  std::sort(knots.begin(), knots.end());
  if (static_cast<int>(knots.size()) > count) knots.resize(count);
  while (static_cast<int>(knots.size()) < count) {
    const std::vector<double> breaks = with_ends(knots);
    std::size_t longest = 0;
    for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
      if (breaks[s + 1] - breaks[s] > breaks[longest + 1] - breaks[longest]) longest = s;
    knots.insert(knots.begin() + static_cast<std::ptrdiff_t>(longest),
                 breaks[longest] + (breaks[longest + 1] - breaks[longest]) / 2);
  }
  widen_spans(knots, 0.01);
}

}  // namespace

std::vector<double> averaged_knots(std::span<const double> r, int degree) {
  std::vector<double> knots;
  for (std::size_t j = 1; j + degree < r.size(); ++j)
    knots.push_back(std::accumulate(r.begin() + j, r.begin() + j + degree, 0.0) / degree);
  return knots;
}

void settle_knots(InteriorKnots& knots, int interior_u, int interior_v) {
  settle(knots.u, interior_u);
  settle(knots.v, interior_v);
}

}  // namespace knotfit
