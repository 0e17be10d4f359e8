#include "pipeline/choose_knots.h"

#include "knotfit/errors.h"
namespace knotfit {

Chosen choose_knots(const ParameterizedPoints& inside, const FitOptions& options, const Tolerance& tolerance,
                    double noise, const Control& control) {
  Chosen chosen;
  chosen.method = options.method;
  if (options.knots) {
    chosen.knots = *options.knots;
    chosen.method = "given";
    return chosen;
  }
  if (options.control_points_u > 0 || options.control_points_v > 0) {
    PlacementOptions place;
    place.interior_u = options.control_points_u - options.degree_u - 1;
    place.interior_v = options.control_points_v - options.degree_v - 1;
    place.degree_u = options.degree_u;
    place.degree_v = options.degree_v;
    place.smoothing = options.smoothing;
    place.feature = options.feature;
    place.user_features = options.user_features;
    place.evaluations = options.evaluations;
    if (tolerance.value > 0) place.keep_by = {0, tolerance.measure, tolerance.share};
    const Placement placement = place_knots(options.method, inside, place, control);
    chosen.knots = placement.knots;
    chosen.criterion = placement.criterion;
    chosen.fits = placement.fits;
    chosen.notes = placement.notes;
    if (placement.status == PlacementStatus::stopped) chosen.status = Status::stopped;
    return chosen;
  }
  RefineOptions refine;
  refine.tolerance = tolerance;
  refine.route = options.route;
  refine.method = options.method;
  refine.effort = options.effort;
  refine.guard = options.guard;
  refine.degree_u = options.degree_u;
  refine.degree_v = options.degree_v;
  refine.max_control_points = options.max_control_points;
  refine.max_fits = options.max_fits;
  refine.smoothing = options.smoothing;
  refine.feature = options.feature;
  refine.user_features = options.user_features;
  refine.evaluations = options.evaluations;
  refine.noise = noise;
  RefineResult found = refine_to_tolerance(inside, refine, control);
  chosen.knots = std::move(found.knots);
  chosen.metric = std::move(found.metric);
  chosen.status = found.status;
  chosen.tried = std::move(found.tried);
  chosen.fits = found.fits;
  chosen.fill_points = found.fill_points;
  chosen.notes = std::move(found.notes);
  if (!found.least_squares) chosen.surface = std::move(found.surface);
  if (options.route == RefineRoute::insert) chosen.method = "insert";
  return chosen;
}

}  // namespace knotfit
