#include "place/shares.h"

#include <algorithm>
#include <numeric>
namespace knotfit {

std::vector<double> equal_shares(std::span<const double> breaks, std::span<const double> mass, int count) {
  const double total = std::accumulate(mass.begin(), mass.end(), 0.0);
  std::vector<double> knots;
  knots.reserve(count);
  double below = 0;
  std::size_t s = 0;
  for (int i = 1; i <= count; ++i) {
    const double wanted = total * i / (count + 1);
    while (s + 1 < mass.size() && below + mass[s] < wanted) below += mass[s++];
    const double t = mass[s] > 0 ? std::clamp((wanted - below) / mass[s], 0.0, 1.0)
                                 : i / (count + 1.0);  // no mass at all: uniform within the span
    knots.push_back(breaks[s] + t * (breaks[s + 1] - breaks[s]));
  }
  return knots;
}

void widen_spans(std::vector<double>& knots, double relative) {
  std::sort(knots.begin(), knots.end());
  const std::size_t spans = knots.size() + 1;
  const double floor = relative / static_cast<double>(spans);
  std::vector<double> length(spans);
  double before = 0;
  for (std::size_t s = 0; s < spans; ++s) {
    const double end = s + 1 < spans ? knots[s] : 1.0;
    length[s] = std::max(end - before, 0.0);
    before = end;
  }
  if (*std::min_element(length.begin(), length.end()) >= floor) return;
  // Widening some shrinks the others, which may need it then: at most a pass a span.
  for (std::size_t before_pass = 0;;) {
    std::size_t fixed_count = 0;
    double fixed = 0, free = 0;
    for (double h : length) {
      fixed_count += h <= floor;
      h <= floor ? fixed += floor : free += h;
    }
    if (fixed_count == before_pass) break;
    before_pass = fixed_count;
    for (double& h : length) h = h <= floor ? floor : h * (1 - fixed) / free;
  }
  double at = 0;
  for (std::size_t s = 0; s + 1 < spans; ++s) knots[s] = at += length[s];
}

std::vector<double> with_ends(std::span<const double> knots) {
  std::vector<double> breaks{0.0};
  breaks.insert(breaks.end(), knots.begin(), knots.end());
  breaks.push_back(1.0);
  return breaks;
}

std::vector<double> uniform_knots(int count) {
  std::vector<double> knots(count);
  for (int i = 0; i < count; ++i) knots[i] = (i + 1.0) / (count + 1.0);
  return knots;
}

}  // namespace knotfit
