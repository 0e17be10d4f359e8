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
  problem.solve({uniform_knots(few - 1), uniform_knots(few - 1)});
  const double uniform = problem.rms();
  InteriorKnots knots{equal_shares(fine.breaks_u(), fine.mass_u, few - 1),
                      equal_shares(fine.breaks_v(), fine.mass_v, few - 1)};
  widen_spans(knots.u, 0.01);
  widen_spans(knots.v, 0.01);
  LevenbergOptions levenberg;
  levenberg.steps = kProbeSteps;
  minimize_over_knots(problem, knots, levenberg);
  const double optimised = std::min(problem.rms(), uniform);
  problem.solve({uniform_knots(2 * few - 1), uniform_knots(2 * few - 1)});
  const double finer = problem.rms(), error = problem.measured(tolerance);

  const double most = std::min(data.degree_u(), data.degree_v()) + 1;
  KnotWorth worth;
  if (!(uniform > 0) || !std::isfinite(uniform)) return worth;  // exact already: nothing to save
  const double order = finer > 0 ? std::clamp(std::log2(uniform / finer), 0.3, most) : most;
  worth.saving = optimised > 0 ? 1 - std::pow(optimised / uniform, 2 / order) : 1;
  const double size = (2.0 * few + data.degree_u()) * (2.0 * few + data.degree_v());
  worth.control_points =
      (1 - worth.saving) * size * std::pow(std::max(error, 1e-300) / tolerance.value, 2 / order);
  return worth;
}

}  // namespace knotfit
