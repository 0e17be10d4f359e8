#include "place/context.h"
#include "place/shares.h"
namespace knotfit {

/// Equal shares of the marginals of the feature measure: a monitor function's integral cut into equal parts
/// [deBoor01 XII], each direction apart. It is what the criterion starts from [METHOD 2.2], and where f = g(u) h(v) the
/// criterion's minimum. Steps; the marginals and the last one are ours:
///  1. the marginal of f in one direction, added over the other;
///  2. knots where its cumulative sum, linear over each cell, reaches i/(k + 1) of the whole;
///  3. no span below 1 % of the mean.
Placement place_equal_share(PlacementContext& context, int interior_u, int interior_v) {
  const FeatureMap& features = context.features();
  Placement placement;
  placement.knots = equal_share(features, interior_u, interior_v);
  widen_spans(placement.knots.u, 0.01);
  widen_spans(placement.knots.v, 0.01);
  placement.criterion = placement.criterion_start = cell_criterion(features, placement.knots);
  placement.status = PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
