#include "refine/worth.h"

#include <algorithm>
#include <cmath>

#include "place/levenberg.h"
#include "place/shares.h"
namespace knotfit {
namespace {

constexpr Index kProbePoints = 20000;
constexpr int kProbeSpans = 10, kProbeSteps = 8;

/// Every k-th point, so that at most kProbePoints are left.
ParameterizedPoints thinned(const ParameterizedPoints& points) {
  const Index stride = (points.size() + kProbePoints - 1) / kProbePoints;
  ParameterizedPoints few;
  few.dimension = points.dimension;
  for (Index k = 0; k < points.size(); k += stride) {
    few.uv.insert(few.uv.end(), {points.u(k), points.v(k)});
    few.values.insert(few.values.end(), points.value(k), points.value(k) + points.dimension);
    if (!points.weights.empty()) few.weights.push_back(points.weights[k]);
  }
  return few;
}

}  // namespace

KnotWorth estimate_worth(const FitProblem& data, const FineModel& fine, const Tolerance& tolerance) {
  const ParameterizedPoints points = thinned(data.points());
  LeastSquaresOptions fit;
  fit.refinement_steps = 0;
  fit.estimate_condition = false;
  fit.use_grid = false;
  FitProblem problem(points, data.degree_u(), data.degree_v(), fit);
  const int few =
      std::min(kProbeSpans, std::max(2, static_cast<int>(std::sqrt(static_cast<double>(points.size()))) / 4));
  // RMS and the error that counts at n spans a direction, on uniform and on optimised knots.
  struct Probe {
    double uniform = 0, optimised = 0, error = 0;
  };
  auto probe = [&](int n) {
    Probe p;
    problem.solve({uniform_knots(n - 1), uniform_knots(n - 1)});
    p.uniform = problem.rms();
    p.error = problem.measured(tolerance);
    InteriorKnots knots{equal_shares(fine.breaks_u(), fine.mass_u, n - 1),
                        equal_shares(fine.breaks_v(), fine.mass_v, n - 1)};
    widen_spans(knots.u, 0.01);
    widen_spans(knots.v, 0.01);
    LevenbergOptions levenberg;
    levenberg.steps = kProbeSteps;
    minimize_over_knots(problem, knots, levenberg);
    p.optimised = std::min(problem.rms(), p.uniform);
    if (problem.rms() < p.uniform) p.error = problem.measured(tolerance);
    return p;
  };
  const Probe coarse = probe(few), fine_probe = probe(2 * few);
  const double most = std::min(data.degree_u(), data.degree_v()) + 1;
  auto order = [&](double before, double after) {
    return after > 0 ? std::clamp(std::log2(before / after), 0.3, most) : most;
  };
  KnotWorth worth;
  if (!(fine_probe.uniform > 0) || !std::isfinite(fine_probe.uniform))
    return worth;  // exact: nothing to save
  worth.saving =
      1 - std::pow(fine_probe.optimised / fine_probe.uniform, 2 / order(coarse.uniform, fine_probe.uniform));
  const double size = (2.0 * few + data.degree_u()) * (2.0 * few + data.degree_v());
  worth.control_points = size * std::pow(std::max(fine_probe.error, 1e-300) / tolerance.value,
                                         2 / order(coarse.optimised, fine_probe.optimised));
  return worth;
}

}  // namespace knotfit
