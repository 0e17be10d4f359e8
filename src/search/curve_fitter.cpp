#include "search/curve_fitter.h"

#include <algorithm>
#include <cmath>

#include "knotfit/refine.h"
#include "nearest/curve_feet.h"
#include "place/periodic.h"
#include "place/shares.h"
#include "place/strip.h"
#include "spline/clamped.h"
#include "spline/strip_surface.h"
namespace knotfit {
namespace {

/// Clamped over [0,1], from one period over its own.
Curve finished(const Curve& curve, bool closed) {
  const double first = curve.knots().first();
  std::vector<double> knots = curve.knots().knots();
  for (double& t : knots) t -= first;
  const Surface strip = clamped(strip_surface(
      Curve(KnotVector(curve.degree(), std::move(knots)), curve.dimension(), curve.control_points())));
  const Curve open = curve_of_strip(strip, closed);
  // The period's end is 1 up to rounding.
  std::vector<double> clean = open.knots().knots();
  for (double& t : clean)
    if (t == open.knots().last()) t = 1;
  return Curve(KnotVector(curve.degree(), std::move(clean)), curve.dimension(), open.control_points());
}

void keep_better(FittedCurve& best, FittedCurve other) {
  if (other.error < best.error) best = std::move(other);
}

}  // namespace

FittedCurve CurveFitter::size(Index control_points) {
  FittedCurve plain = fit(control_points, nullptr);
  return plain.error <= measure_.value ? held(std::move(plain), control_points, 0) : plain;
}

FittedCurve CurveFitter::fixed_size(Index control_points) {
  FittedCurve plain = fit(control_points, nullptr);
  const double rms = plain.rms;
  return held(std::move(plain), control_points, rms);
}

FittedCurve CurveFitter::given(const std::vector<double>& knots) {
  FittedCurve plain = fit(knots, nullptr);
  const double rms = plain.rms;
  return held(std::move(plain), knots, rms);
}

template <class Size>
FittedCurve CurveFitter::held(FittedCurve plain, const Size& size, double scale) {
  scale = std::max(scale, energy_scale(measure_));
  if (!plain.swings.swings || stopped() || !(scale > 0)) return plain;
  FittedCurve held = fit(size, std::make_shared<const DataEnergy>(strip_raster(points_, scale)));
  if (held.empty() || (held.swings.swings && !(held.swings.largest < plain.swings.largest))) return plain;
  held.swing_before = plain.swings.largest;
  return held;
}

FittedCurve CurveFitter::fit(Index control_points, const Energy& energy) {
  CurveProblem problem(points_, options_.degree_u, options_.smoothing, energy);
  std::vector<double> knots = place(problem, control_points, energy);
  FittedCurve best = take(problem, knots);
  if (corrections_ > 0 && correct(problem, knots)) {
    keep_better(best, take(problem, knots));
    knots = place(problem, control_points, energy);  // for the parameters as they are now
    correct(problem, knots);
    keep_better(best, take(problem, knots));
  }
  fits_ += problem.fits();
  judge(best);
  return best;
}

FittedCurve CurveFitter::fit(const std::vector<double>& knots, const Energy& energy) {
  CurveProblem problem(points_, options_.degree_u, options_.smoothing, energy);
  FittedCurve best = take(problem, knots);
  if (corrections_ > 0 && correct(problem, knots)) keep_better(best, take(problem, knots));
  fits_ += problem.fits();
  judge(best);
  return best;
}

std::vector<double> CurveFitter::place(CurveProblem& problem, Index control_points, const Energy& energy) {
  PlacementOptions place;
  static_cast<KnotOptions&>(place) = static_cast<const KnotOptions&>(options_);
  // A period has as many knots as control points, the seam one of them.
  place.interior_u =
      static_cast<int>(points_.closed ? control_points - 1 : control_points - options_.degree_u - 1);
  place.energy = energy;
  const Placement placed = place_curve_knots(options_.method, problem.points(), place, control_);
  fits_ += placed.fits;
  for (const std::string& note : placed.notes)
    if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
  std::vector<double> knots = placed.knots.u;
  if (!points_.closed) return knots;
  knots.insert(knots.begin(), 0.0);
  if (placement_method(options_.method).traits.moves_knots)
    optimize_period(problem, knots, [&] { return stopped(); });
  return knots;
}

FittedCurve CurveFitter::take(CurveProblem& problem, const std::vector<double>& knots) {
  FittedCurve fitted;
  if (!problem.solve(knots)) return fitted;
  const Curve& curve = problem.curve();
  fitted.control_points = points_.closed ? static_cast<Index>(knots.size()) : curve.size();
  fitted.error = problem.measured(measure_);
  fitted.errors = problem.errors();
  fitted.rms = problem.measured({.value = 0, .measure = ErrorMeasure::rms});
  const double first = curve.knots().first();
  for (double t : problem.points().t) fitted.t.push_back(std::clamp(problem.on_curve(t) - first, 0.0, 1.0));
  fitted.curve = finished(curve, points_.closed);
  return fitted;
}

bool CurveFitter::correct(CurveProblem& problem, const std::vector<double>& knots) {
  bool moved = false;
  CurvePoints& points = problem.points();
  for (int round = 0; round < corrections_ && !stopped(); ++round) {
    if (!problem.solve(knots)) break;
    const double before = problem.phi();
    std::vector<double> feet;
    for (double t : points.t) feet.push_back(problem.on_curve(t));
    curve_feet(problem.curve(), points.closed, points.values, feet);
    for (Index k = 0; k < points.size(); ++k) {
      const double t = points.closed ? feet[k] - std::floor(feet[k]) : feet[k];
      moved |= t != points.t[k];
      points.t[k] = t;
    }
    if (!problem.solve(knots) || !(problem.phi() < before * (1 - 1e-4))) break;
  }
  return moved;
}

void CurveFitter::judge(FittedCurve& fitted) const {
  if (fitted.empty()) return;
  CurvePoints points = points_;
  points.t = fitted.t;
  if (points.closed)
    for (double& t : points.t) t -= std::floor(t);  // the period's end is its start
  const double unit = measure_.value > 0 ? measure_.value : fitted.rms;
  if (unit > 0) fitted.swings = measure_swings(fitted.curve, points, fitted.errors, unit);
}

}  // namespace knotfit
