#include "place/context.h"
#include "place/shares.h"
namespace knotfit {

/// Equally spaced knots, u_i = i/(k + 1), i = 1..k: the baseline everything is held against.
Placement place_uniform(PlacementContext&, int interior_u, int interior_v) {
  return {.knots = {uniform_knots(interior_u), uniform_knots(interior_v)},
          .status = PlacementStatus::converged};
}

}  // namespace knotfit
