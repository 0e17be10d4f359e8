#include "pipeline/crowding.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "data/neighbours.h"
namespace knotfit {
namespace {

constexpr double kPointsACell = 4, kOfThePoints = 0.9;
constexpr Index kSampled = 5000;  // points whose stretch is taken
constexpr Index kNeighbour = 4;   // the one it is taken to

double occupied_share(const ParameterizedPoints& points) {
  const Index n = points.size();
  const Index side = std::max<Index>(1, std::lround(std::sqrt(static_cast<double>(n) / kPointsACell)));
  std::vector<Index> count(side * side, 0);
  auto cell = [&](double x) { return std::min(side - 1, static_cast<Index>(x * static_cast<double>(side))); };
  for (Index k = 0; k < n; ++k) ++count[cell(points.u(k)) * side + cell(points.v(k))];
  std::sort(count.begin(), count.end(), std::greater<>());
  Index held = 0, cells = 0;
  while (static_cast<double>(held) < kOfThePoints * static_cast<double>(n)) held += count[cells++];
  return static_cast<double>(cells) / static_cast<double>(count.size());
}

double stretch_ratio(const ParameterizedPoints& points) {
  const DistinctPoints distinct = distinct_points(points);
  const Neighbours neighbours = plain_neighbours(distinct);
  const Index step = std::max<Index>(1, distinct.size() / kSampled), sampled = distinct.size() / step;
  std::vector<double> stretch(sampled);
  parallel_chunks(sampled, [&](Index, Index begin, Index end) {
    std::array<std::uint32_t, kNeighbour + 1> index;
    std::array<double, kNeighbour + 1> square;
    for (Index i = begin; i < end; ++i) {
      const Index k = i * step, found = neighbours.nearest(distinct.u[k], distinct.v[k], index, square);
      double apart = 0;
      for (int e = 0; e < distinct.dimension; ++e)
        apart = std::hypot(apart, distinct.value(index[found - 1])[e] - distinct.value(k)[e]);
      stretch[i] = square[found - 1] > 0 ? apart / std::sqrt(square[found - 1]) : 0;
    }
  });
  std::erase_if(stretch, [](double s) { return !(s > 0); });
  if (stretch.size() < 10) return 1;
  std::sort(stretch.begin(), stretch.end());
  return stretch[stretch.size() * 9 / 10] / stretch[stretch.size() / 10];
}

}  // namespace

Crowding measure_crowding(const ParameterizedPoints& points) {
  return {occupied_share(points), stretch_ratio(points)};
}

}  // namespace knotfit
