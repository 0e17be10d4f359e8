#include "knotfit/fit_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
#include "pipeline/curve_notes.h"
#include "pipeline/message.h"
#include "pipeline/request.h"
#include "pipeline/verdict.h"
#include "search/curve_search.h"
#include "spline/strip_surface.h"
namespace knotfit {
namespace {

constexpr double kNoiseSeen = 0.02;  // of the tolerance: less noise does not matter

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
                    "more points or a lower {}",
                    points.size(), least, o.degree, remedy_text(Remedy::degree)));
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

SearchOptions search_options(const CurveFitOptions& o) {
  SearchOptions search;
  search.degree_u = o.degree;
  search.smoothing = o.smoothing;
  search.feature = o.feature;
  search.user_features = o.user_features;
  search.evaluations = o.evaluations;
  search.method = o.method;
  search.max_control_points = o.max_control_points;
  search.max_fits = o.max_fits;
  return search;
}

}  // namespace

CurveFitResult fit_curve(const CurvePoints& points, const CurveFitOptions& options, const Control& control) {
  check_options(points, options);
  const ParameterizedPoints border = on_border(points);
  CurveFitResult result;
  result.closed = points.closed;
  if (!(bounding_diagonal(border) > 0) && points.dimension > 1)
    throw InvalidInput("all points are equal: there is no curve to fit");
  const Frame frame(border);
  const bool with_size = options.knots || options.control_points > 0;
  Request request = make_request(options.tolerance, with_size, border, frame.rounding(), frame.scale());
  if (!request.with_tolerance()) request.inside.measure = ErrorMeasure::rms;
  result.diagonal = request.diagonal;
  result.asked = request.asked;
  result.tolerance = request.asked.value;
  CurvePoints inside = points;
  inside.values = frame.inside(border).values;

  const SearchOptions search = search_options(options);
  CurveFitter fitter(inside, search, options.corrections, request.inside, control);
  CurveSearch found{.status = Status::fixed_size, .best = {}, .tried = {}};
  if (options.knots) {
    found.best = fitter.given(*options.knots);
  } else if (!request.searched) {
    found.best = fitter.fixed_size(options.control_points);
    if (control.stop.stop_requested()) found.status = Status::stopped;
  } else {
    Index most = options.max_control_points > 0 ? options.max_control_points : points.size() / 2;
    most = std::clamp<Index>(most, options.degree + 1, points.size());
    const double noise = estimate_noise(inside);
    if (noise > kNoiseSeen * request.inside.value) result.noise = noise * frame.scale();
    found = search_curve_sizes(fitter, inside, search, request.inside, most, result.noise / frame.scale(),
                               frame.scale(), control);
  }
  const FittedCurve& best = found.best;
  result.tried = std::move(found.tried);
  result.method = options.knots ? "given" : options.method;
  result.fits = fitter.fits();
  result.notes = fitter.notes();
  if (best.empty()) {
    result.status = Status::failed;
    result.message = message_of(result, points.size());
    return result;
  }

  result.control_points = best.control_points;
  const Surface strip = frame.outside(strip_surface(best.curve));
  result.curve = curve_of_strip(strip, points.closed);
  result.knots = result.curve.knots().interior();
  result.t = best.t;
  ParameterizedPoints checked = border;
  for (Index k = 0; k < points.size(); ++k) checked.uv[2 * k] = result.t[k];
  // Apart from the fit's own evaluation, on the curve as it is handed out.
  result.errors = recheck_errors(strip, checked);
  result.error = summarize_errors(result.errors, checked);
  result.measured = options.tolerance ? measured_error(result.errors, result.asked) : result.error.max;
  result.swings = best.swings;
  for (double* x : {&result.swings.distance, &result.swings.beyond_box}) *x *= frame.scale();
  const bool holds = options.tolerance && result.measured <= result.tolerance;
  result.reached = holds && !result.swings.swings;
  result.status = status_of(
      {found.status, request.searched, request.with_tolerance(), holds, result.swings.swings, false});
  result.message = message_of(result, points.size());
  if (best.swing_before > 0)
    result.notes.push_back(held_note(best.swing_before, result.swings.largest, "curve"));
  const std::vector<std::string> of_curve = curve_notes(result, points);
  result.notes.insert(result.notes.begin(), of_curve.begin(), of_curve.end());
  return result;
}

}  // namespace knotfit
