#include "place/context.h"
#include "place/shares.h"
namespace knotfit {

/// Equal shares of the marginals of the feature measure: what the criterion starts from.
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
