#include "knotfit/fit_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
#include "pipeline/curve_fitter.h"
#include "pipeline/curve_notes.h"
#include "pipeline/frame.h"
#include "pipeline/requirements.h"
#include "pipeline/verdict.h"
#include "search/attempts.h"
namespace knotfit {
namespace {

constexpr double kNoiseSeen = 0.02;  // of the tolerance: less noise does not matter

/// Of two curves that do not hold, the one to keep: one that keeps to its data, else the least error.
bool nearer(const FittedCurve& a, const FittedCurve& b) {
  if (b.empty() || a.empty()) return !a.empty();
  if (a.swings.swings != b.swings.swings) return !a.swings.swings;
  return a.error < b.error;
}

/// Up by a tenth until a size holds, down one at a time while two sizes below may hold.
Status search(CurveFitter& fitter, const CurveFitOptions& options, const Tolerance& tolerance, Index most,
              const Control& control, double scale, NoisePlateau& plateau, CurveFitResult& result,
              FittedCurve& best) {
  const long budget = options.max_fits > 0 ? options.max_fits : 100000;
  FittedCurve nearest;
  nearest.swings.swings = true;
  bool held_but_swings = false, only_noise = false;
  const auto attempt = [&](Index n) {
    FittedCurve fitted = fitter.size(n);
    const bool holds = fitter.holds(fitted);
    only_noise = !holds && !fitted.empty() && plateau.add(n, fitted.rms);
    held_but_swings = held_but_swings || (fitted.error <= tolerance.value && !holds);
    result.tried.push_back({static_cast<int>(n), fitted.error * scale, holds});
    if (control.progress)
      control.progress({.stage = "size search",
                        .error = result.tried.back().error,
                        .tolerance = tolerance.value * scale,
                        .size_u = static_cast<int>(n),
                        .size_v = 1,
                        .fits = fitter.fits()});
    if (holds)
      best = std::move(fitted);
    else if (nearer(fitted, nearest))
      nearest = std::move(fitted);
    return holds;
  };
  const auto start = std::chrono::steady_clock::now();
  const auto late = [&] { return out_of_time(control, start); };
  const auto cut = [&](Status otherwise) {
    return control.stop.stop_requested() ? Status::stopped : late() ? Status::time_limit : otherwise;
  };
  const auto over = [&] { return control.stop.stop_requested() || late() || fitter.fits() > budget; };
  Index n = fitter.least();
  for (;; n = std::min(most, n + std::max<Index>(1, n / 10))) {
    const bool holds = attempt(n);
    if (holds) break;
    if (over() || only_noise || n == most) {
      best = std::move(nearest);
      if (control.stop.stop_requested() || late()) return cut(Status::limit_reached);
      if (held_but_swings) return Status::swings;
      if (only_noise) return Status::tolerance_below_noise;
      if (over()) return Status::limit_reached;
      return options.max_control_points > 0 ? Status::limit_reached : Status::data_too_sparse;
    }
  }
  for (int failed = 0; failed < 2 && n > fitter.least() && !over();) {
    --n;
    if (std::any_of(result.tried.begin(), result.tried.end(),
                    [&](const CurveSizeTried& t) { return t.control_points == n && !t.holds; })) {
      ++failed;
      continue;
    }
    if (attempt(n))
      failed = 0;
    else
      ++failed;
  }
  return cut(Status::reached);
}

void check_options(const CurvePoints& points, const CurveFitOptions& o) {
  validate(points);
  if (o.degree < 1 || o.degree > kMaxDegree)
    throw InvalidInput(fmt::format("degree {}: it must be 1 to {}", o.degree, kMaxDegree));
  if (!(o.smoothing >= 0) || !std::isfinite(o.smoothing))
    throw InvalidInput("the smoothing floor must be finite and at least 0");
  if (!o.user_features.empty()) validate(o.user_features);
  if (o.corrections < 0)
    throw InvalidInput(fmt::format("{} corrections: they may not be negative", o.corrections));
  if (points.function && o.corrections > 0)
    throw InvalidInput("the parameters of a function y over x are its x: they cannot be corrected");
  const Index least = o.degree + 1;
  if (points.size() < least)
    throw InvalidInput(
        fmt::format("{} points are fewer than the {} control points of one piece of degree {}; give "
                    "more points or a lower --degree",
                    points.size(), least, o.degree));
  if (std::all_of(points.t.begin(), points.t.end(), [&](double t) { return t == points.t[0]; }))
    throw InvalidInput("all points have the same parameter: there is no curve to fit");
  const Index n =
      o.knots ? static_cast<Index>(o.knots->size()) + (points.closed ? 0 : least) : o.control_points;
  if (n == 0 && !o.knots) return;
  if (n < least)
    throw InvalidInput(fmt::format("{} control points: degree {} needs at least {}", n, o.degree, least));
  if (n > points.size())
    throw InvalidInput(fmt::format("{} points are fewer than {} control points", points.size(), n));
  if (o.knots && points.closed) {
    const auto& k = *o.knots;
    for (std::size_t i = 0; i < k.size(); ++i)
      if (!(k[i] >= 0 && k[i] < 1) || (i > 0 && !(k[i] > k[i - 1])))
        throw InvalidInput(fmt::format("knot {} is {}: knots of a closed curve increase in [0,1)", i, k[i]));
  } else if (o.knots) {
    KnotVector::clamped(o.degree, *o.knots);  // refuses what are no knots
  }
}

std::string message_of(const CurveFitResult& r) {
  std::string what = fmt::format("{} control points: RMS error {:.4g}, largest {:.4g}", r.control_points,
                                 r.error.rms, r.error.max);
  switch (r.status) {
    case Status::reached:
      return fmt::format("{}; the tolerance {:.4g} holds", what, r.tolerance);
    case Status::fixed_size:
      return what;
    case Status::tolerance_below_noise:
      return fmt::format(
          "{}; the tolerance {:.4g} is below the noise of the data (standard deviation about {:.3g}): more "
          "control points would only follow the noise",
          what, r.tolerance, r.noise);
    case Status::swings:
      return r.measured <= r.tolerance
                 ? fmt::format(
                       "{}; the tolerance {:.4g} holds at the points, but between them the curve swings",
                       what, r.tolerance)
                 : fmt::format(
                       "{}; every curve found that holds the tolerance {:.4g} at the points swings "
                       "between them",
                       what, r.tolerance);
    case Status::data_too_sparse:
      return fmt::format("{}; half as many control points as points do not hold the tolerance {:.4g}", what,
                         r.tolerance);
    case Status::limit_reached:
      return fmt::format("{}; the limit on control points or fits came before the tolerance {:.4g}", what,
                         r.tolerance);
    case Status::stopped:
      return "stopped; best so far " + what;
    case Status::time_limit:
      return "the time limit came; best so far " + what;
    case Status::failed:
      return "no curve: the normal equations of these knots cannot be solved";
    default:
      return fmt::format("{}; the tolerance {:.4g} does not hold", what, r.tolerance);
  }
}

}  // namespace

CurveFitResult fit_curve(const CurvePoints& points, const CurveFitOptions& options, const Control& control) {
  check_options(points, options);
  const ParameterizedPoints border = on_border(points);
  CurveFitResult result;
  result.closed = points.closed;
  result.diagonal = bounding_diagonal(border);
  if (!(result.diagonal > 0) && points.dimension > 1)
    throw InvalidInput("all points are equal: there is no curve to fit");
  const Frame frame(border);
  const bool searched = !options.knots && options.control_points == 0;
  if (options.tolerance) {
    result.asked = absolute_tolerance(*options.tolerance, border, result.diagonal, frame.rounding());
    result.tolerance = result.asked.value;
  } else if (searched) {
    throw InvalidInput("give a tolerance, a number of control points, or knots");
  }
  CurvePoints inside = points;
  inside.values = frame.inside(border).values;
  Tolerance tolerance = options.tolerance ? result.asked : Tolerance{0, ErrorMeasure::rms, 1};
  tolerance.value = std::max(0.0, (result.tolerance * (1 - 1e-9) - 4 * frame.rounding()) / frame.scale());

  CurveFitter fitter(inside, options, tolerance, control);
  FittedCurve best;
  Status status = Status::fixed_size;
  if (options.knots) {
    best = fitter.given(*options.knots);
  } else if (!searched) {
    best = fitter.fixed_size(options.control_points);
    if (control.stop.stop_requested()) status = Status::stopped;
  } else {
    Index most = options.max_control_points > 0 ? options.max_control_points : points.size() / 2;
    most = std::clamp<Index>(most, options.degree + 1, points.size());
    const double noise = estimate_noise(inside);
    if (noise > kNoiseSeen * tolerance.value) result.noise = noise * frame.scale();
    NoisePlateau plateau(result.noise / frame.scale(), points.size(), points.dimension);
    status = search(fitter, options, tolerance, most, control, frame.scale(), plateau, result, best);
  }
  result.method = options.knots ? "given" : options.method;
  result.fits = fitter.fits();
  result.notes = fitter.notes();
  if (best.empty()) {
    result.status = Status::failed;
    result.message = message_of(result);
    return result;
  }

  result.control_points = best.control_points;
  const Curve& unit = best.curve;
  std::vector<double> net;
  for (Index i = 0; i < unit.size(); ++i)
    for (int copy = 0; copy < 2; ++copy)
      net.insert(net.end(), unit.control_points().begin() + i * unit.dimension(),
                 unit.control_points().begin() + (i + 1) * unit.dimension());
  const Surface strip =
      frame.outside(Surface(unit.knots(), KnotVector::uniform(1, 0), unit.dimension(), std::move(net)));
  std::vector<double> row;
  for (Index i = 0; i < strip.size_u(); ++i) {
    const auto c = strip.control_point(i, 0);
    row.insert(row.end(), c.begin(), c.end());
  }
  if (points.closed)
    std::copy_n(row.begin(), points.dimension, row.end() - points.dimension);  // to the last bit
  result.curve = Curve(strip.knots_u(), strip.dimension(), std::move(row));
  result.knots = result.curve.knots().interior();
  ParameterizedPoints checked = border;
  for (Index k = 0; k < points.size(); ++k) {
    result.t.push_back(best.t[k]);
    checked.uv[2 * k] = result.t.back();
  }
  // Apart from the fit's own evaluation, on the curve as it is handed out.
  result.errors = recheck_errors(strip, checked);
  result.error = summarize_errors(result.errors, checked);
  result.measured = options.tolerance ? measured_error(result.errors, result.asked) : result.error.max;
  result.swings = best.swings;
  for (double* x : {&result.swings.distance, &result.swings.beyond_box}) *x *= frame.scale();
  const bool holds = options.tolerance && result.measured <= result.tolerance;
  result.reached = holds && !result.swings.swings;
  const bool cut = status == Status::stopped || status == Status::time_limit;
  result.status = !options.tolerance || cut               ? status
                  : holds && !result.reached              ? Status::swings
                  : result.reached                        ? Status::reached
                  : searched && status != Status::reached ? status
                                                          : Status::not_reached;
  result.message = message_of(result);
  if (best.swing_before > 0)
    result.notes.push_back(held_note(best.swing_before, result.swings.largest, "curve"));
  const std::vector<std::string> of_curve = curve_notes(result, points);
  result.notes.insert(result.notes.begin(), of_curve.begin(), of_curve.end());
  return result;
}

}  // namespace knotfit
