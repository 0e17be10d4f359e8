#include "data/distinct_points.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/parallel.h"
namespace knotfit {
namespace {

constexpr Index kStripPoints = 16384;  // points a strip, about: small enough to share out
constexpr Index kMostStrips = 64;

struct Keyed {
  double u, v;
  Index k;
  bool operator<(const Keyed& o) const { return u != o.u ? u < o.u : v != o.v ? v < o.v : k < o.k; }
};

// Values of u that cut the points into strips of about equal size, from a regular sample.
std::vector<double> strip_bounds(const ParameterizedPoints& points) {
  const Index n = points.size(), strips = std::clamp<Index>(n / kStripPoints, 1, kMostStrips);
  std::vector<double> bounds;
  if (strips == 1) return bounds;
  const Index samples = 64 * strips;
  std::vector<double> sample(static_cast<std::size_t>(samples));
  for (Index i = 0; i < samples; ++i) sample[i] = points.u(i * n / samples);
  std::sort(sample.begin(), sample.end());
  for (Index s = 1; s < strips; ++s) bounds.push_back(sample[s * samples / strips]);
  bounds.erase(std::unique(bounds.begin(), bounds.end()), bounds.end());
  return bounds;
}

// The weighted mean, as a step from the first value so that large offsets keep their digits.
void merge_values(const ParameterizedPoints& points, std::span<const Keyed> group, double* out) {
  const double* first = points.value(group[0].k);
  double weight = 0;
  for (const Keyed& p : group) weight += points.weight(p.k);
  for (int d = 0; d < points.dimension; ++d) {
    double step = 0;
    for (const Keyed& p : group) step += points.weight(p.k) / weight * (points.value(p.k)[d] - first[d]);
    out[d] = first[d] + step;
  }
}

}  // namespace

DistinctPoints distinct_points(const ParameterizedPoints& points) {
  const Index n = points.size();
  const std::vector<double> bounds = strip_bounds(points);
  const Index strips = static_cast<Index>(bounds.size()) + 1;

  std::vector<std::uint8_t> strip(static_cast<std::size_t>(n));
  parallel_chunks(n, [&](Index, Index begin, Index end) {
    for (Index k = begin; k < end; ++k)
      strip[k] = static_cast<std::uint8_t>(std::upper_bound(bounds.begin(), bounds.end(), points.u(k)) -
                                           bounds.begin());
  });
  std::vector<Index> start(static_cast<std::size_t>(strips + 1), 0);
  for (Index k = 0; k < n; ++k) ++start[strip[k] + 1];
  for (Index s = 0; s < strips; ++s) start[s + 1] += start[s];
  std::vector<Keyed> sorted(static_cast<std::size_t>(n));
  std::vector<Index> next(start.begin(), start.end() - 1);
  for (Index k = 0; k < n; ++k) sorted[next[strip[k]]++] = {points.u(k), points.v(k), k};

  auto same = [&](Index a, Index b) { return sorted[a].u == sorted[b].u && sorted[a].v == sorted[b].v; };
  std::vector<Index> distinct(static_cast<std::size_t>(strips), 0);
  parallel_for(strips, [&](Index s) {
    std::sort(sorted.begin() + start[s], sorted.begin() + start[s + 1]);
    for (Index i = start[s]; i < start[s + 1]; ++i) distinct[s] += i == start[s] || !same(i - 1, i);
  });

  DistinctPoints result;
  result.dimension = points.dimension;
  result.strip_start.assign(1, 0);
  for (Index s = 0; s < strips; ++s) result.strip_start.push_back(result.strip_start.back() + distinct[s]);
  const auto size = static_cast<std::size_t>(result.strip_start.back());
  result.u.resize(size), result.v.resize(size);
  result.values.resize(size * static_cast<std::size_t>(points.dimension));
  result.of.resize(static_cast<std::size_t>(n));
  const bool weighted = !points.weights.empty() || size != static_cast<std::size_t>(n);
  if (weighted) result.weights.resize(size);
  const double mean_weight =
      points.weights.empty() ? 1 : parallel_sum<double>(n, [&](Index begin, Index end) {
        double sum = 0;
        for (Index k = begin; k < end; ++k) sum += points.weights[k] / static_cast<double>(n);
        return sum;
      });
  parallel_for(strips, [&](Index s) {
    Index to = result.strip_start[s];
    for (Index i = start[s], j; i < start[s + 1]; i = j, ++to) {
      for (j = i + 1; j < start[s + 1] && same(i, j);) ++j;
      for (Index q = i; q < j; ++q) result.of[sorted[q].k] = static_cast<std::uint32_t>(to);
      const std::span<const Keyed> group(sorted.data() + i, static_cast<std::size_t>(j - i));
      result.u[to] = sorted[i].u, result.v[to] = sorted[i].v;
      double* value = result.values.data() + to * points.dimension;
      if (group.size() == 1)
        std::copy_n(points.value(group[0].k), points.dimension, value);
      else
        merge_values(points, group, value);
      if (weighted) {
        double sum = 0;
        for (const Keyed& p : group) sum += points.weight(p.k) / mean_weight;
        result.weights[to] = sum;
      }
    }
  });
  return result;
}

}  // namespace knotfit
