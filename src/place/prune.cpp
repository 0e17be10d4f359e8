// Knots removed while a tolerance holds.
#include <fmt/format.h>

#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/place.h"
#include "place/full_lspia.h"
namespace knotfit {

Placement prune_knots(const ParameterizedPoints& points, InteriorKnots knots, const Tolerance& tolerance,
                      const PlacementOptions& options, const Control& control) {
  if (!(tolerance.value > 0) || !std::isfinite(tolerance.value))
    throw InvalidInput(fmt::format("the tolerance is {}: it must be positive and finite", tolerance.value));
  LeastSquaresOptions fit;
  fit.smoothing = options.smoothing;
  fit.refinement_steps = 0;
  fit.estimate_condition = false;
  fit.energy = options.energy;
  FitProblem problem(points, options.degree_u, options.degree_v, fit);
  Placement placement;
  const auto stop = [&] { return control.stop.stop_requested(); };
  const auto holds = [&] { return problem.measured(tolerance) <= tolerance.value; };
  if (problem.solve(knots) && holds()) {
    remove_least_knots(problem, knots, 0, 0, holds, stop);
    placement.status = stop() ? PlacementStatus::stopped : PlacementStatus::converged;
  } else {
    placement.status = PlacementStatus::limit;
    placement.notes.push_back("the knots given do not hold the tolerance: none was removed");
  }
  placement.knots = std::move(knots);
  placement.fits = problem.fits();
  return placement;
}

}  // namespace knotfit
