#include "knotfit/fit_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "correct/curve_feet.h"
#include "fit/curve_problem.h"
#include "knotfit/errors.h"
#include "pipeline/curve_notes.h"
#include "pipeline/frame.h"
#include "pipeline/requirements.h"
#include "place/periodic.h"
#include "place/shares.h"
#include "place/strip.h"
#include "spline/clamped.h"
namespace knotfit {
namespace {

/// One size fitted: the knots of the method, parameters corrected where wanted.
struct Fitted {
  Index control_points = 0;
  double error = std::numeric_limits<double>::infinity();  ///< that counts, in the frame
  std::vector<double> knots, t;
  Curve curve;
};

class CurveFitter {
 public:
  CurveFitter(const CurvePoints& inside, const CurveFitOptions& options, const Tolerance& measure,
              const Control& control)
      : inside_(inside), options_(options), measure_(measure), control_(control) {}

  Index least() const { return options_.degree + 1; }
  long fits() const { return fits_; }
  const std::vector<std::string>& notes() const { return notes_; }

  Fitted size(Index control_points) {
    CurveProblem problem(inside_, options_.degree, options_.smoothing);
    std::vector<double> knots = place(problem, control_points);
    Fitted best = take(problem, knots);
    if (options_.corrections > 0 && correct(problem, knots)) {
      keep_better(best, take(problem, knots));
      knots = place(problem, control_points);  // for the parameters as they are now
      correct(problem, knots);
      keep_better(best, take(problem, knots));
    }
    fits_ += problem.fits();
    return best;
  }

  Fitted given(const std::vector<double>& knots) {
    CurveProblem problem(inside_, options_.degree, options_.smoothing);
    Fitted best = take(problem, knots);
    if (options_.corrections > 0 && correct(problem, knots)) keep_better(best, take(problem, knots));
    fits_ += problem.fits();
    return best;
  }

 private:
  bool stopped() const { return control_.stop.stop_requested(); }

  std::vector<double> place(CurveProblem& problem, Index control_points) {
    PlacementOptions place;
    place.degree_u = options_.degree;
    // A period has as many knots as control points, the seam one of them.
    place.interior_u =
        static_cast<int>(inside_.closed ? control_points - 1 : control_points - options_.degree - 1);
    place.smoothing = options_.smoothing;
    place.feature = options_.feature;
    place.user_features = options_.user_features;
    place.evaluations = options_.evaluations;
    const Placement placed = place_curve_knots(options_.method, problem.points(), place, control_);
    fits_ += placed.fits;
    for (const std::string& note : placed.notes)
      if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
    std::vector<double> knots = placed.knots.u;
    if (!inside_.closed) return knots;
    knots.insert(knots.begin(), 0.0);
    if (options_.method == "optimal") optimize_period(problem, knots, [&] { return stopped(); });
    return knots;
  }

  Fitted take(CurveProblem& problem, const std::vector<double>& knots) {
    Fitted fitted;
    if (!problem.solve(knots)) return fitted;
    fitted.knots = knots;
    fitted.curve = problem.curve();
    fitted.control_points = inside_.closed ? static_cast<Index>(knots.size()) : fitted.curve.size();
    fitted.error = problem.measured(measure_);
    for (double t : problem.points().t) fitted.t.push_back(problem.on_curve(t));
    return fitted;
  }

  static void keep_better(Fitted& best, Fitted other) {
    if (other.error < best.error) best = std::move(other);
  }

  /// Rounds of feet and fits at these knots. \return whether any parameter moved
  bool correct(CurveProblem& problem, const std::vector<double>& knots) {
    bool moved = false;
    CurvePoints& points = problem.points();
    for (int round = 0; round < options_.corrections && !stopped(); ++round) {
      if (!problem.solve(knots)) break;
      const double before = problem.phi();
      std::vector<double> feet;
      for (double t : points.t) feet.push_back(problem.on_curve(t));
      correction::curve_feet(problem.curve(), points.closed, points.values, feet);
      for (Index k = 0; k < points.size(); ++k) {
        const double t = points.closed ? feet[k] - std::floor(feet[k]) : feet[k];
        moved |= t != points.t[k];
        points.t[k] = t;
      }
      if (!problem.solve(knots) || !(problem.phi() < before * (1 - 1e-4))) break;
    }
    return moved;
  }

  const CurvePoints& inside_;
  const CurveFitOptions& options_;
  Tolerance measure_;
  const Control& control_;
  long fits_ = 0;
  std::vector<std::string> notes_;
};

/// Up by a tenth until a size holds, down one at a time while two sizes below may hold.
Status search(CurveFitter& fitter, const CurveFitOptions& options, const Tolerance& tolerance, Index most,
              const Control& control, double scale, CurveFitResult& result, Fitted& best) {
  const long budget = options.max_fits > 0 ? options.max_fits : 100000;
  Fitted nearest;
  const auto attempt = [&](Index n) {
    Fitted fitted = fitter.size(n);
    const bool holds = fitted.error <= tolerance.value;
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
    else if (fitted.error < nearest.error)
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
    if (over() || n == most) {
      best = std::move(nearest);
      if (over()) return cut(Status::limit_reached);
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

/// Clamped over [0,1], from one period over its own.
Curve finished(const Curve& curve, bool closed) {
  const double first = curve.knots().first();
  std::vector<double> knots = curve.knots().knots();
  for (double& t : knots) t -= first;
  std::vector<double> net;
  const int d = curve.dimension();
  for (Index i = 0; i < curve.size(); ++i)
    for (int copy = 0; copy < 2; ++copy)
      net.insert(net.end(), curve.control_points().begin() + i * d,
                 curve.control_points().begin() + (i + 1) * d);
  const Surface strip =
      clamped(Surface(KnotVector(curve.degree(), knots), KnotVector::uniform(1, 0), d, net));
  std::vector<double> row;
  for (Index i = 0; i < strip.size_u(); ++i) {
    const auto c = strip.control_point(i, 0);
    row.insert(row.end(), c.begin(), c.end());
  }
  if (closed) std::copy_n(row.begin(), d, row.end() - d);  // to the last bit
  // The period's end is 1 up to rounding.
  std::vector<double> clean = strip.knots_u().knots();
  for (double& t : clean)
    if (t == strip.knots_u().last()) t = 1;
  return Curve(KnotVector(curve.degree(), std::move(clean)), d, std::move(row));
}

std::string message_of(const CurveFitResult& r) {
  std::string what = fmt::format("{} control points: RMS error {:.4g}, largest {:.4g}", r.control_points,
                                 r.error.rms, r.error.max);
  switch (r.status) {
    case Status::reached:
      return fmt::format("{}; the tolerance {:.4g} holds", what, r.tolerance);
    case Status::fixed_size:
      return what;
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
  Fitted best;
  Status status = Status::fixed_size;
  if (options.knots) {
    best = fitter.given(*options.knots);
  } else if (!searched) {
    best = fitter.size(options.control_points);
    if (control.stop.stop_requested()) status = Status::stopped;
  } else {
    Index most = options.max_control_points > 0 ? options.max_control_points : points.size() / 2;
    most = std::clamp<Index>(most, options.degree + 1, points.size());
    status = search(fitter, options, tolerance, most, control, frame.scale(), result, best);
  }
  result.method = options.knots ? "given" : options.method;
  result.fits = fitter.fits();
  result.notes = fitter.notes();
  if (best.knots.empty() && best.t.empty()) {
    result.status = Status::failed;
    result.message = message_of(result);
    return result;
  }

  const double first = best.curve.knots().first();
  result.control_points = best.control_points;
  const Curve unit = finished(best.curve, points.closed);
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
    result.t.push_back(std::clamp(best.t[k] - first, 0.0, 1.0));
    checked.uv[2 * k] = result.t.back();
  }
  // Apart from the fit's own evaluation, on the curve as it is handed out.
  result.errors = recheck_errors(strip, checked);
  result.error = summarize_errors(result.errors, checked);
  result.measured = options.tolerance ? measured_error(result.errors, result.asked) : result.error.max;
  result.reached = options.tolerance && result.measured <= result.tolerance;
  const bool cut = status == Status::stopped || status == Status::time_limit;
  result.status = !options.tolerance || cut               ? status
                  : result.reached                        ? Status::reached
                  : searched && status != Status::reached ? status
                                                          : Status::not_reached;
  result.message = message_of(result);
  for (std::string& note : curve_notes(result, points)) result.notes.push_back(std::move(note));
  return result;
}

}  // namespace knotfit
