#include "knotfit/refine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/deadline.h"
#include "fit/error_measure.h"
#include "fit/fit_problem.h"
#include "knotfit/exceptions.h"
#include "search/routes.h"
#include "verify/swing_limits.h"
#include "verify/swings.h"
namespace knotfit {

RefineResult refine_to_tolerance(const ParameterizedPoints& points, const RefineOptions& options,
                                 const Control& control) {
  const Tolerance& t = options.tolerance;
  if (!(t.value > 0) || !std::isfinite(t.value))
    throw InvalidInput(fmt::format("the tolerance is {}: it must be positive and finite", t.value));
  if (row_of(t.measure).needs_share && !(t.share > 0 && t.share < 1))
    throw InvalidInput(fmt::format("a percentile of {} %: it must lie between 0 and 100 %", 100 * t.share));
  double largest = 0;
  for (double x : points.values) largest = std::max(largest, std::abs(x));
  if (t.value < largest * std::numeric_limits<double>::epsilon() / 2)
    throw InvalidInput(
        fmt::format("the tolerance {} is below the rounding of values as large as {}", t.value, largest));
  if (!(options.span_ratio >= 0) || !std::isfinite(options.span_ratio))
    throw InvalidInput(fmt::format(
        "a ratio of spans of {}: it must be positive, or 0 for that of the error model", options.span_ratio));
  if (options.max_fits < 0) throw InvalidInput("the number of fits allowed is negative");
  const Index minimum = Index{options.degree_u + 1} * (options.degree_v + 1);
  if (options.max_control_points != 0 && options.max_control_points < minimum)
    throw InvalidInput(
        fmt::format("at most {} control points are fewer than the {} of one patch of degree {}x{}",
                    options.max_control_points, minimum, options.degree_u, options.degree_v));
  const PlacementMethod& method = placement_method(options.method);
  RefineOptions whole = options;
  if (!whole.sites) whole.sites = std::make_shared<verify::SwingSites>(points, verify::kSearchPlaces);
  if (!whole.energy)
    whole.energy = make_data_energy(points, energy_scale(options.tolerance), whole.sites->indexed());
  LeastSquaresOptions fit = search_fits(whole);
  fit.use_grid = true;
  FitProblem problem(points, options.degree_u, options.degree_v, fit);
  const Deadline deadline(control);
  RefineResult result;
  if (options.route == RefineRoute::insert)
    result = insert_isolines(problem, whole, control);
  else
    result = method.traits.moves_knots ? search_optimal(problem, whole, control)
                                       : search_placed(problem, whole, control);
  if (result.method.empty()) result.method = options.method;
  if (!result.holds && !result.surface.empty()) hold(result, points, whole, deadline.left());
  return result;
}

}  // namespace knotfit
