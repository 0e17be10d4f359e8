#include <algorithm>
#include <numeric>

#include "place/context.h"
#include "place/shares.h"
namespace knotfit {
namespace {

/// Centroids of `count` regions of equal mass, the mass spread evenly over equal cells of [0,1].
std::vector<double> centroids(const std::vector<double>& mass, int count) {
  if (count == 0) return {};
  std::vector<double> breaks(mass.size() + 1);
  for (std::size_t i = 0; i < breaks.size(); ++i)
    breaks[i] = static_cast<double>(i) / static_cast<double>(mass.size());
  const std::vector<double> borders = with_ends(equal_shares(breaks, mass, count - 1));
  std::vector<double> knots;
  std::size_t cell = 0;
  for (int r = 0; r < count; ++r) {
    double total = 0, moment = 0;
    for (;; ++cell) {
      const double low = std::max(borders[r], breaks[cell]),
                   high = std::min(borders[r + 1], breaks[cell + 1]);
      if (high > low) {
        const double part = mass[cell] * (high - low);
        total += part;
        moment += part * (low + high) / 2;
      }
      if (cell + 1 == mass.size() || breaks[cell + 1] >= borders[r + 1]) break;
    }
    knots.push_back(total > 0 ? moment / total : (borders[r] + borders[r + 1]) / 2);
  }
  return knots;
}

}  // namespace

/// Regions of equal accumulated feature, their centroids as knots: so, in one line and without a paper to name, later
/// literature on feature-based knots describes the method it compares with. Steps, ours from that line:
///  1. the marginal of the feature measure in one direction;
///  2. as many regions as knots, each with the same share of it;
///  3. each knot at its region's centroid, weighted by the feature.
/// Against equal shares the border regions keep half a share on their outer side.
Placement place_centroid(PlacementContext& context, int interior_u, int interior_v) {
  const FeatureMap& f = context.features();
  std::vector<double> u(f.size_u, 0.0), v(f.size_v, 0.0);
  for (Index i = 0; i < f.size_u; ++i)
    for (Index j = 0; j < f.size_v; ++j) {
      u[i] += f.f[i * f.size_v + j];
      v[j] += f.f[i * f.size_v + j];
    }
  for (auto* mass : {&u, &v})
    if (!(std::accumulate(mass->begin(), mass->end(), 0.0) > 0)) std::fill(mass->begin(), mass->end(), 1.0);
  Placement placement;
  placement.knots = {centroids(u, interior_u), centroids(v, interior_v)};
  widen_spans(placement.knots.u, 0.01);
  widen_spans(placement.knots.v, 0.01);
  placement.status = PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
