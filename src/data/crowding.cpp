#include "data/crowding.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
namespace knotfit {
namespace {

constexpr Index kSampled = 20000;
constexpr Index kNeighbour = 4;
constexpr double kCloseInParameters = 0.25, kApartInSpace = 0.5;  // of the medians

}  // namespace

double crowded_share(const IndexedPoints& points) {
  const DistinctPoints& distinct = points.distinct;
  const Neighbours& neighbours = points.neighbours;
  const Index step = std::max<Index>(1, distinct.size() / kSampled), sampled = distinct.size() / step;
  std::vector<double> parameters(sampled), space(sampled);
  parallel_chunks(sampled, [&](Index, Index begin, Index end) {
    std::array<std::uint32_t, kNeighbour + 1> index;
    std::array<double, kNeighbour + 1> square;
    for (Index i = begin; i < end; ++i) {
      const Index k = i * step, found = neighbours.nearest(distinct.u[k], distinct.v[k], index, square);
      parameters[i] = std::sqrt(square[found - 1]);
      for (int e = 0; e < distinct.dimension; ++e)
        space[i] = std::hypot(space[i], distinct.value(index[found - 1])[e] - distinct.value(k)[e]);
    }
  });
  auto middle = [](std::vector<double> x) {
    std::nth_element(x.begin(), x.begin() + x.size() / 2, x.end());
    return x[x.size() / 2];
  };
  const double close = kCloseInParameters * middle(parameters), apart = kApartInSpace * middle(space);
  Index crowded = 0;
  for (Index i = 0; i < sampled; ++i) crowded += parameters[i] < close && space[i] > apart;
  return static_cast<double>(crowded) / static_cast<double>(sampled);
}

}  // namespace knotfit
