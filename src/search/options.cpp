// What a search tells the placement methods and the fits that it makes.
#include "search/routes.h"
namespace knotfit {

PlacementOptions placement_options(const RefineOptions& options) {
  PlacementOptions placement;
  static_cast<KnotOptions&>(placement) = static_cast<const KnotOptions&>(options);
  placement.energy = options.energy;
  placement.keep_by = options.tolerance;
  return placement;
}

LeastSquaresOptions search_fits(const RefineOptions& options) {
  LeastSquaresOptions fit;
  fit.smoothing = options.smoothing;
  fit.refinement_steps = 0;
  fit.estimate_condition = false;
  fit.use_grid = false;  // knots move
  fit.energy = options.energy;
  return fit;
}

}  // namespace knotfit
