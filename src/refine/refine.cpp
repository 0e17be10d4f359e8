#include "knotfit/refine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "knotfit/errors.h"
#include "place/context.h"
#include "refine/size_solver.h"
namespace knotfit {

std::string_view to_string(Status status) {
  switch (status) {
    case Status::not_run:
      return "not_run";
    case Status::fixed_size:
      return "fixed_size";
    case Status::reached:
      return "reached";
    case Status::not_reached:
      return "not_reached";
    case Status::data_too_sparse:
      return "data_too_sparse";
    case Status::tolerance_below_noise:
      return "tolerance_below_noise";
    case Status::folded:
      return "folded";
    case Status::limit_reached:
      return "limit_reached";
    case Status::time_limit:
      return "time_limit";
    case Status::stopped:
      return "stopped";
    case Status::failed:
      return "failed";
  }
  return "unknown";
}

RefineResult refine_to_tolerance(const ParameterizedPoints& points, const RefineOptions& options,
                                 const Control& control) {
  const Tolerance& t = options.tolerance;
  if (!(t.value > 0) || !std::isfinite(t.value))
    throw InvalidInput(fmt::format("the tolerance is {}: it must be positive and finite", t.value));
  if (t.measure == ErrorMeasure::percentile && !(t.share > 0 && t.share < 1))
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
  find_method(options.method);
  LeastSquaresOptions fit;
  fit.smoothing = options.smoothing;
  fit.refinement_steps = 0;
  fit.estimate_condition = false;
  const bool optimal = options.method == "optimal";
  // Knots move on scattered points only: the grid's own factor knows nothing of them.
  const bool insert = options.route == RefineRoute::insert;
  fit.use_grid = !(insert && optimal && can_optimise_insertion(points));
  FitProblem problem(points, options.degree_u, options.degree_v, fit);
  RefineResult result;
  if (insert)
    result = insert_isolines(problem, options, control);
  else
    result = optimal ? search_optimal(problem, options, control) : search_placed(problem, options, control);
  if (result.method.empty()) result.method = options.method;
  return result;
}

}  // namespace knotfit
