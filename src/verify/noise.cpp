#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "base/parallel.h"
#include "data/parameter_groups.h"
#include "knotfit/verify.h"
#include "verify/local_reference.h"
#include "verify/random.h"
namespace knotfit {
namespace verify {

double find_noise(const IndexedPoints& indexed, unsigned long long seed, Index stencils) {
  const DistinctPoints& points = indexed.distinct;
  if (points.size() < shape_for({1, 30}, 30).points) return 0;
  Random random(seed, Random::Stream::noise);
  std::vector<Index> centre(static_cast<std::size_t>(stencils));
  for (Index& k : centre) k = static_cast<Index>(random() * static_cast<double>(points.size()));
  std::vector<double> found(centre.size(), -1);
  parallel_chunks(
      stencils,
      [&](Index, Index begin, Index end) {
        StencilGatherer gatherer(points, indexed.neighbours, kMappedShape);
        for (Index i = begin; i < end; ++i)
          if (gatherer.gather(points.u[centre[i]], points.v[centre[i]]) > 0)
            found[i] = gatherer.scale() > 0 ? gatherer.scale() * gatherer.kriging().likely_noise() : 0;
      },
      4);
  std::erase(found, -1);  // places where nothing can be said
  return found.empty() ? 0 : median(std::move(found));
}

}  // namespace verify

double estimate_noise(const ParameterizedPoints& points, unsigned long long seed) {
  validate(points);
  return verify::find_noise(IndexedPoints(points), seed);
}

double estimate_noise(const CurvePoints& points) {
  validate(points);
  constexpr Index kLeast = 8;
  constexpr double kNormal = 0.6745;  // median of |x| of a normal distribution of deviation 1
  const ParameterGroups groups = group_by_parameter(points.t);
  std::vector<Index> order;  // the first of equal parameters
  for (Index g = 0; g < groups.size(); ++g) order.push_back(groups.group(g).front());
  const Index n = groups.size();
  if (n < kLeast) return 0;
  std::vector<double> off;
  for (Index k = 2; k + 2 < n; ++k) {
    const Index near[] = {k - 2, k - 1, k + 1, k + 2};
    double weight[4], squares = 1;
    for (int i = 0; i < 4; ++i) {
      weight[i] = 1;
      for (int j = 0; j < 4; ++j)
        if (j != i)
          weight[i] *= (points.t[order[k]] - points.t[order[near[j]]]) /
                       (points.t[order[near[i]]] - points.t[order[near[j]]]);
      squares += weight[i] * weight[i];
    }
    for (int e = 0; e < points.dimension; ++e) {
      double r = points.value(order[k])[e];
      for (int i = 0; i < 4; ++i) r -= weight[i] * points.value(order[near[i]])[e];
      off.push_back(std::abs(r) / std::sqrt(squares));
    }
  }
  return median(std::move(off)) / kNormal;
}

}  // namespace knotfit
