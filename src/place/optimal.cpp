// Knots that minimise the fitting error itself [METHOD 3, "the default call"].
#include <limits>

#include "place/context.h"
#include "place/relocate.h"
#include "place/shares.h"
namespace knotfit {

/// Levenberg-Marquardt from three starts (two-stage error model, the error model iterated at the counts
/// from uniform, equal marginal shares of the feature measure), relocation of the best, ties.
Placement place_optimal(PlacementContext& context, int interior_u, int interior_v) {
  FitProblem& problem = context.problem();
  std::vector<InteriorKnots> starts;
  context.options().rounds = 4;
  context.options().keep_by = {0, ErrorMeasure::rms};
  starts.push_back(place_error_model(context, interior_u, interior_v).knots);
  starts.push_back(equal_share(context.features(), interior_u, interior_v));
  starts.push_back(error_model_from(context, {uniform_knots(interior_u), uniform_knots(interior_v)}, 12));

  LevenbergOptions levenberg;
  levenberg.stop = [&] { return context.stop_requested(); };
  double phi = std::numeric_limits<double>::infinity();
  Placement placement;
  placement.knots = starts.front();
  for (InteriorKnots& start : starts) {
    widen_spans(start.u, 0.01);
    widen_spans(start.v, 0.01);
    if (const double reached = minimize_over_knots(problem, start, levenberg); reached < phi) {
      phi = reached;
      placement.knots = start;
    }
  }
  phi = relocate_knots(problem, placement.knots, phi, levenberg);
  tie_knots(problem, placement.knots, phi, levenberg);
  placement.status = context.stop_requested() ? PlacementStatus::stopped : PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
