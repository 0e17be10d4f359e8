#include "knotfit/fit_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "fit/problem.h"
#include "knotfit/errors.h"
#include "pipeline/frame.h"
namespace knotfit {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// No surface runs through points that are all equal or lie on one straight line in R^d, d >= 2.
/// Rank by the two largest spreads: the far point from the first, then the far point from that line.
void check_extent(const ParameterizedPoints& points) {
  const int d = points.dimension;
  const double rounding = Frame(points).rounding();
  auto farthest = [&](auto&& distance) {
    double most = 0;
    Index at = 0;
    for (Index k = 0; k < points.size(); ++k)
      if (const double x = distance(points.value(k)); x > most) {
        most = x;
        at = k;
      }
    return std::pair{most, at};
  };
  const double* origin = points.value(0);
  const auto [length, far] = farthest([&](const double* p) {
    double sum = 0;
    for (int e = 0; e < d; ++e) sum += (p[e] - origin[e]) * (p[e] - origin[e]);
    return std::sqrt(sum);
  });
  if (d == 1) return;
  if (!(length > 4 * rounding)) throw InvalidInput("all points are equal: there is no surface to fit");
  std::vector<double> direction(d);
  for (int e = 0; e < d; ++e) direction[e] = (points.value(far)[e] - origin[e]) / length;
  const double off = farthest([&](const double* p) {
                       double along = 0, sum = 0;
                       for (int e = 0; e < d; ++e) along += (p[e] - origin[e]) * direction[e];
                       for (int e = 0; e < d; ++e) {
                         const double x = p[e] - origin[e] - along * direction[e];
                         sum += x * x;
                       }
                       return std::sqrt(sum);
                     }).first;
  if (!(off > std::max(8 * rounding, 1e-14 * length)))
    throw InvalidInput("all points lie on one straight line: there is no surface to fit");
}

/// Parameters must spread over both directions, or a whole family of surfaces fits alike.
void check_parameters(const ParameterizedPoints& points) {
  double low[2] = {1, 1}, high[2] = {0, 0};
  for (Index k = 0; k < points.size(); ++k)
    for (int axis : {0, 1}) {
      low[axis] = std::min(low[axis], points.uv[2 * k + axis]);
      high[axis] = std::max(high[axis], points.uv[2 * k + axis]);
    }
  for (int axis : {0, 1})
    if (!(high[axis] > low[axis]))
      throw InvalidInput(fmt::format("all points have the same parameter {} = {}: there is no surface to fit",
                                     axis == 0 ? "u" : "v", low[axis]));
}

Tolerance absolute_tolerance(const ToleranceRequest& request, const ParameterizedPoints& points,
                             double diagonal, double rounding) {
  if (!(request.value > 0) || !std::isfinite(request.value))
    throw InvalidInput(fmt::format("the tolerance is {}: it must be positive and finite", request.value));
  if (request.measure == ErrorMeasure::percentile && !(request.share > 0 && request.share <= 1))
    throw InvalidInput(
        fmt::format("a share of {} % of the points: it must lie in (0, 100]", 100 * request.share));
  if (request.relative && !(diagonal > 0))
    throw InvalidInput(points.dimension == 1 ? "all values are equal, so a tolerance in % of their range "
                                               "means nothing; give it as an absolute value"
                                             : "all points are equal: there is no surface to fit");
  Tolerance t{request.relative ? request.value / 100 * diagonal : request.value, request.measure,
              request.share};
  if (t.measure == ErrorMeasure::percentile && t.share == 1) t.measure = ErrorMeasure::max;
  if (t.value < 16 * rounding)
    throw InvalidInput(
        fmt::format("the tolerance {} is below what coordinates of this size can hold in double "
                    "precision ({}); ask for a larger one, or move the data nearer to the origin",
                    t.value, 16 * rounding));
  return t;
}

std::string measure_name(const Tolerance& t) {
  switch (t.measure) {
    case ErrorMeasure::max:
      return "largest error";
    case ErrorMeasure::rms:
      return "RMS error";
    case ErrorMeasure::percentile:
      break;
  }
  return fmt::format("error of {:g} % of the points", 100 * t.share);
}

std::string sentence(const FitResult& r, Index points) {
  const std::string size = fmt::format("{} x {} = {} control points", r.surface.size_u(), r.surface.size_v(),
                                       r.surface.control_point_count());
  const std::string measured =
      r.tolerance > 0
          ? fmt::format("{} {:.4g}, tolerance {:.4g}", measure_name(r.asked), r.measured, r.tolerance)
          : fmt::format("RMS error {:.4g}, largest {:.4g}", r.error.rms, r.error.max);
  switch (r.status) {
    case Status::reached:
      return fmt::format("{} hold the tolerance: {}", size, measured);
    case Status::fixed_size:
      return fmt::format("{}: {}", size, measured);
    case Status::not_reached:
      return fmt::format("{} do not hold the tolerance: {}", size, measured);
    case Status::data_too_sparse:
      return fmt::format(
          "the {} points are too sparse for this tolerance: no size within the limit of control points that "
          "such data supports holds it; best {}: {}",
          points, size, measured);
    case Status::tolerance_below_noise:
      return fmt::format(
          "the tolerance is below the noise of the data (standard deviation about {:.3g}): more control "
          "points would only follow the noise; best {}: {}",
          r.noise, size, measured);
    case Status::limit_reached:
      return fmt::format("the limit on control points or fits was reached; best {}: {}", size, measured);
    case Status::time_limit:
      return fmt::format("the time limit cut the search short; {} {}: {}", r.reached ? "so far" : "best",
                         size, measured);
    case Status::stopped:
      return fmt::format("stopped; {} {}: {}", r.reached ? "so far" : "best", size, measured);
    case Status::failed:
      return fmt::format("the fit failed its own check; {}: {}", size, measured);
    case Status::not_run:
      break;
  }
  return "nothing was fitted";
}

/// Knots given or placed at a fixed size, or searched to the tolerance. Works in the frame.
struct Chosen {
  InteriorKnots knots, metric;
  Status status = Status::fixed_size;
  double criterion = 0;
  std::vector<SizeTried> tried;
  long fits = 0;
  std::string method;
};

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
    if (tolerance.value > 0) place.keep_by = {0, tolerance.measure, tolerance.share};
    const Placement placement = place_knots(options.method, inside, place, control);
    chosen.knots = placement.knots;
    chosen.criterion = placement.criterion;
    chosen.fits = placement.fits;
    if (placement.status == PlacementStatus::stopped) chosen.status = Status::stopped;
    return chosen;
  }
  RefineOptions refine;
  refine.tolerance = tolerance;
  refine.route = options.route;
  refine.method = options.method;
  refine.degree_u = options.degree_u;
  refine.degree_v = options.degree_v;
  refine.max_control_points = options.max_control_points;
  refine.max_fits = options.max_fits;
  refine.smoothing = options.smoothing;
  refine.feature = options.feature;
  refine.user_features = options.user_features;
  refine.noise = noise;
  RefineResult found = refine_to_tolerance(inside, refine, control);
  chosen.knots = std::move(found.knots);
  chosen.metric = std::move(found.metric);
  chosen.status = found.status;
  chosen.tried = std::move(found.tried);
  chosen.fits = found.fits;
  if (options.route == RefineRoute::insert) chosen.method = "insert";
  return chosen;
}

void check_size(const ParameterizedPoints& points, const FitOptions& o) {
  const Index n = points.size(), patch = Index{o.degree_u + 1} * (o.degree_v + 1);
  if (n < patch)
    throw InvalidInput(
        fmt::format("{} points are fewer than the {} control points of one patch of degree {}x{}; "
                    "give more points or a lower --degree",
                    n, patch, o.degree_u, o.degree_v));
  Index size_u = o.control_points_u, size_v = o.control_points_v;
  if (o.knots) {
    size_u = static_cast<Index>(o.knots->u.size()) + o.degree_u + 1;
    size_v = static_cast<Index>(o.knots->v.size()) + o.degree_v + 1;
  } else if (size_u == 0 && size_v == 0) {
    return;
  }
  if (size_u < o.degree_u + 1 || size_v < o.degree_v + 1)
    throw InvalidInput(fmt::format("{} x {} control points: degree {}x{} needs at least {} x {}", size_u,
                                   size_v, o.degree_u, o.degree_v, o.degree_u + 1, o.degree_v + 1));
  if (n < size_u * size_v)
    throw InvalidInput(
        fmt::format("{} points are fewer than {} x {} = {} control points; ask for fewer control points "
                    "or a lower --degree",
                    n, size_u, size_v, size_u * size_v));
}

/// A note where points share parameters but not values: least squares goes between them.
void note_duplicates(const ParameterizedPoints& points, std::vector<std::string>& notes) {
  std::vector<Index> order(points.size());
  for (Index k = 0; k < points.size(); ++k) order[k] = k;
  auto key = [&](Index k) { return std::pair{points.u(k), points.v(k)}; };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  Index shared = 0;
  for (std::size_t i = 1; i < order.size(); ++i) shared += key(order[i]) == key(order[i - 1]);
  if (shared > 0)
    notes.push_back(
        fmt::format("{} points have the same parameters as another: the surface goes between them", shared));
}

}  // namespace

FitResult fit_surface(const ParameterizedPoints& points, const FitOptions& options, const Control& control) {
  const auto start = std::chrono::steady_clock::now();
  validate(points);
  for (int degree : {options.degree_u, options.degree_v})
    if (degree < 1 || degree > kMaxDegree)
      throw InvalidInput(fmt::format("degree {}: it must be 1 to {}", degree, kMaxDegree));
  check_size(points, options);
  check_extent(points);
  check_parameters(points);

  FitResult result;
  result.map = points.map;
  result.height_field = points.height_field;
  result.diagonal = bounding_diagonal(points);
  const Frame frame(points);
  const bool searched = !options.knots && options.control_points_u == 0 && options.control_points_v == 0;
  if (options.tolerance) {
    result.asked = absolute_tolerance(*options.tolerance, points, result.diagonal, frame.rounding());
    result.tolerance = result.asked.value;
  } else if (searched) {
    throw InvalidInput("give a tolerance, a number of control points, or knots");
  }
  note_duplicates(points, result.notes);

  const ParameterizedPoints inside = frame.inside(points);
  // Undoing the frame moves control points by up to an ulp of the data: leave room for it.
  Tolerance tolerance = result.asked;
  tolerance.value = std::max(0.0, (result.tolerance * (1 - 1e-9) - 4 * frame.rounding()) / frame.scale());
  if (searched) {
    const double noise = estimate_noise(inside);
    if (noise > 0.02 * tolerance.value) result.noise = noise * frame.scale();
  }
  Control rest = control;
  if (control.time_limit > 0) rest.time_limit = std::max(1e-3, control.time_limit - seconds_since(start));
  Chosen chosen = choose_knots(inside, options, tolerance, result.noise / frame.scale(), rest);

  // The last fit, with the refinement step that takes the smoothing floor's share out; without it
  // where the search's own surface holds the tolerance and this one by a hair does not.
  LeastSquaresOptions fit;
  fit.smoothing = options.smoothing;
  FitProblem problem(inside, options.degree_u, options.degree_v, fit);
  bool solved = problem.solve(chosen.knots);
  if (solved && options.tolerance && chosen.status == Status::reached &&
      problem.measured(tolerance) > tolerance.value) {
    problem.set_refinement_steps(0);
    solved = problem.solve(chosen.knots);
  }
  result.fits = chosen.fits + problem.fits();
  result.method = chosen.method;
  result.criterion = chosen.criterion;
  result.tried = std::move(chosen.tried);
  if (!solved) {
    result.status = Status::failed;
    result.message =
        "no surface: the normal equations of these knots cannot be solved; ask for fewer control points";
    return result;
  }
  result.surface = frame.outside(problem.surface());
  result.condition = problem.condition();
  result.smoothing = problem.smoothing();
  result.empty_cells = problem.empty_cells();

  // The verdict comes from residuals of their own path, on the surface as it is handed out.
  result.errors = recheck_errors(result.surface, points);
  const std::vector<double> fitted = problem.errors();
  bool sound = true;
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    if (!std::isfinite(result.errors[k])) sound = false;
    result.recheck_difference =
        std::max(result.recheck_difference, std::abs(result.errors[k] - fitted[k] * frame.scale()));
  }
  // Both paths round: a few ulps of the data, and of the net times the degree.
  const double rounding =
      64 * (frame.rounding() + result.surface.scale() * 1.2e-16) * (options.degree_u + options.degree_v) +
      1e-10 * frame.scale();
  if (!sound || !(result.recheck_difference <= rounding)) {
    result.status = Status::failed;
    result.message =
        fmt::format("the surface failed its own check: errors measured apart from the fit differ by {:.3g}",
                    result.recheck_difference);
    return result;
  }
  result.error = summarize_errors(result.errors, points);
  if (options.tolerance) {
    result.measured = measured_error(result.errors, result.asked);
    result.reached = result.measured <= result.tolerance;
    const bool cut = chosen.status == Status::stopped || chosen.status == Status::time_limit;
    result.status = cut                                            ? chosen.status
                    : result.reached                               ? Status::reached
                    : searched && chosen.status != Status::reached ? chosen.status
                                                                   : Status::not_reached;
  } else {
    result.measured = result.error.max;
    result.status = chosen.status;
  }
  if (result.empty_cells > 0)
    result.notes.push_back(fmt::format(
        "{} knot cells hold no point: the smoothing floor shapes the surface there", result.empty_cells));

  if (options.between && !control.stop.stop_requested()) {
    BetweenOptions between;
    between.metric_u = chosen.metric.u;
    between.metric_v = chosen.metric.v;
    // In the frame, where heights of 1e8 cost the reference no digits.
    const double scale = frame.scale();
    const double unit =
        options.tolerance ? result.tolerance : std::max(result.error.max, 16 * frame.rounding());
    if (unit > 0) {
      result.between = measure_between(problem.surface(), inside, unit / scale, between, control);
      for (double* x : {&result.between.between, &result.between.bound, &result.between.noise}) *x *= scale;
      for (ThinPlace& place : result.between.thin_places) place.error_bar *= scale;
    }
  }
  result.message = sentence(result, points.size());
  return result;
}

}  // namespace knotfit
