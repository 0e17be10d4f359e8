#include "knotfit/refine.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "fit/data_energy.h"
#include "fit/problem.h"
#include "knotfit/exceptions.h"
#include "place/context.h"
#include "search/size_solver.h"
#include "verify/swing_limits.h"
#include "verify/swings.h"
namespace knotfit {
namespace {

constexpr double kHoldWork = 1e10;  // operations of a fit, about a second: larger nets are not held

/// Where nothing holds: knots whose surfaces came nearest, held to the data by an energy for errors of their own size, may be
/// nearer than the best that does not swing by itself.
void hold(RefineResult& result, const ParameterizedPoints& points, const RefineOptions& options,
          const Control& control) {
  LeastSquaresOptions fit = search_fits(options);
  const auto start = std::chrono::steady_clock::now();
  const auto cut = [&] {
    const bool stopped = control.stop.stop_requested();
    if (stopped || out_of_time(control, start))
      result.status = stopped ? Status::stopped : Status::time_limit;
    return result.status == Status::stopped || result.status == Status::time_limit;
  };
  for (const InteriorKnots& knots : {result.nearest, result.knots}) {
    fit.energy = options.energy;
    FitProblem problem(points, options.degree_u, options.degree_v, fit);
    const double work = problem.work(static_cast<Index>(knots.u.size()) + options.degree_u + 1,
                                     static_cast<Index>(knots.v.size()) + options.degree_v + 1);
    if (work > kHoldWork || cut() || !problem.solve(knots)) continue;
    for (const double times : {1.0, 4.0}) {
      if (cut()) return;
      fit.energy = own_energy(points, options.tolerance, times * problem.rms());
      FitProblem held(points, options.degree_u, options.degree_v, fit);
      result.fits += 1;
      if (!held.solve(knots)) continue;
      const double error = held.measured(options.tolerance);
      if (!result.swings && !(error < result.error)) break;
      if (options.sites->measure(held.surface(), held.errors(), options.tolerance.value).swings) continue;
      result.surface = held.surface();
      result.knots = knots;
      result.error = error;
      result.swings = false;
      result.least_squares = false;
      break;
    }
  }
}

}  // namespace

std::shared_ptr<const DataEnergy> own_energy(const ParameterizedPoints& points, const Tolerance& tolerance,
                                             double error) {
  return make_data_energy(points, std::max(error, energy_scale(tolerance)));
}

double energy_scale(const Tolerance& tolerance) {
  // A root mean square lets single errors be larger: three times it is what most of them stay below.
  return (tolerance.measure == ErrorMeasure::rms ? 3 : 1) * tolerance.value;
}

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
    case Status::swings:
      return "swings";
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
  RefineOptions whole = options;
  if (!whole.energy) whole.energy = make_data_energy(points, energy_scale(options.tolerance));
  if (!whole.sites) whole.sites = std::make_shared<verify::SwingSites>(points, verify::kSearchPlaces);
  LeastSquaresOptions fit = search_fits(whole);
  fit.use_grid = true;
  FitProblem problem(points, options.degree_u, options.degree_v, fit);
  const auto start = std::chrono::steady_clock::now();
  RefineResult result;
  if (options.route == RefineRoute::insert)
    result = insert_isolines(problem, whole, control);
  else
    result = options.method == "optimal" ? search_optimal(problem, whole, control)
                                         : search_placed(problem, whole, control);
  if (result.method.empty()) result.method = options.method;
  if (!result.holds && !result.surface.empty()) hold(result, points, whole, time_left(control, start));
  return result;
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
