#include "parameterize/row_parameters.h"

#include <algorithm>
#include <cmath>
#include <numeric>
namespace knotfit::parameterize {
namespace {

constexpr int kMostRounds = 200;
constexpr double kSettled = 1e-13;  // change of a gap, of 1 in all

}  // namespace

double spacing_length(const double* a, const double* b, RowSpacing spacing) {
  if (spacing == RowSpacing::uniform) return 1;
  const double chord = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  return spacing == RowSpacing::chord ? chord : std::sqrt(chord);
}

std::vector<double> cumulative_parameters(std::span<const double> lengths) {
  std::vector<double> result = {0};
  for (double length : lengths) result.push_back(result.back() + length);
  const double total = result.back();
  if (!(total > 0)) return {};
  for (double& t : result) t /= total;
  return result;
}

std::vector<double> averaged_parameters(std::span<const double> lengths, Index gaps) {
  const Index lines = gaps > 0 ? static_cast<Index>(lengths.size()) / gaps : 0;
  std::vector<double> gap(static_cast<std::size_t>(gaps), 1 / static_cast<double>(gaps)), next;
  std::vector<Index> known;
  for (int round = 0; round < kMostRounds; ++round) {
    next.assign(gap.size(), 0);
    known.assign(gap.size(), 0);
    for (Index r = 0; r < lines; ++r) {
      const std::span<const double> line = lengths.subspan(static_cast<std::size_t>(r * gaps), gap.size());
      double own = 0, mean = 0;
      for (Index j = 0; j < gaps; ++j)
        if (!std::isnan(line[j])) own += line[j], mean += gap[j];
      if (!(own > 0 && mean > 0)) continue;
      for (Index j = 0; j < gaps; ++j)
        if (!std::isnan(line[j])) next[j] += line[j] * (mean / own), ++known[j];
    }
    double sum = 0;
    Index count = 0;
    for (Index j = 0; j < gaps; ++j)
      if (known[j] > 0) next[j] /= static_cast<double>(known[j]), sum += next[j], ++count;
    if (!(sum > 0)) return {};
    for (Index j = 0; j < gaps; ++j)
      if (known[j] == 0) next[j] = sum / static_cast<double>(count);
    sum = std::accumulate(next.begin(), next.end(), 0.0);
    double change = 0;
    for (Index j = 0; j < gaps; ++j) {
      next[j] /= sum;
      change = std::max(change, std::abs(next[j] - gap[j]));
    }
    gap.swap(next);
    if (change < kSettled) break;
  }
  return cumulative_parameters(gap);
}

}  // namespace knotfit::parameterize
