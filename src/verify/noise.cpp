#include <algorithm>

#include "base/median.h"
#include "base/parallel.h"
#include "knotfit/verify.h"
#include "verify/local_reference.h"
#include "verify/random.h"
namespace knotfit {
namespace verify {

double find_noise(const DistinctPoints& points, const Neighbours& neighbours, unsigned long long seed,
                  Index stencils) {
  if (points.size() < shape_for({1, 30}, 30).points) return 0;
  Random random(seed, Random::Stream::noise);
  std::vector<Index> centre(static_cast<std::size_t>(stencils));
  for (Index& k : centre) k = static_cast<Index>(random() * static_cast<double>(points.size()));
  std::vector<double> found(centre.size(), -1);
  parallel_chunks(
      stencils,
      [&](Index, Index begin, Index end) {
        StencilGatherer gatherer(points, neighbours, kMappedShape);
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
  const DistinctPoints distinct = distinct_points(points);
  return verify::find_noise(distinct, plain_neighbours(distinct), seed);
}

}  // namespace knotfit
