#include "search/worth.h"

#include <algorithm>
#include <cmath>

#include "data/thinned.h"
#include "place/levenberg.h"
#include "place/relocate.h"
#include "place/shares.h"
namespace knotfit {
namespace {

constexpr Index kProbePoints = 20000;
constexpr int kProbeSpans = 10, kProbeSteps = 8, kProbePasses = 2;

}  // namespace

KnotWorth estimate_worth(const FitProblem& data, const FineModel& fine, const Tolerance& tolerance,
                         bool thorough) {
  const ParameterizedPoints points = thinned(data.points(), kProbePoints);
  LeastSquaresOptions fit;
  fit.refinement_steps = 0;
  fit.estimate_condition = false;
  MovingFit problem(points, data.degree_u(), data.degree_v(), fit);
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
    LevenbergOptions levenberg;
    levenberg.steps = kProbeSteps;
    auto optimise = [&](InteriorKnots knots) {
      const double phi = minimize_over_knots(problem, knots, levenberg);
      if (thorough) relocate_knots(problem, knots, phi, levenberg, {kProbePasses, 2});
      if (!(problem.rms() < p.optimised)) return;
      p.optimised = problem.rms();
      p.error = problem.measured(tolerance);
    };
    p.optimised = p.uniform;
    InteriorKnots knots{equal_shares(fine.breaks_u(), fine.mass_u, n - 1),
                        equal_shares(fine.breaks_v(), fine.mass_v, n - 1)};
    widen_spans(knots.u, 0.01);
    widen_spans(knots.v, 0.01);
    optimise(std::move(knots));
    if (thorough) optimise({uniform_knots(n - 1), uniform_knots(n - 1)});
    return p;
  };
  const double most = std::min(data.degree_u(), data.degree_v()) + 1;
  // Relocation lowers errors that small sizes do not resolve: after it, the order is nearer to the spline's own.
  const double least = thorough ? most / 2 : 0.3;
  auto order = [&](double before, double after) {
    return after > 0 ? std::clamp(std::log2(before / after), least, most) : most;
  };
  const Probe coarse = probe(few), fine_probe = probe(2 * few);
  KnotWorth worth;
  if (!(fine_probe.uniform > 0) || !std::isfinite(fine_probe.uniform))
    return worth;  // exact: nothing to save
  worth.saving = 1 - std::pow(fine_probe.optimised / fine_probe.uniform,
                              2 / (thorough ? most : order(coarse.uniform, fine_probe.uniform)));
  const double size = (2.0 * few + data.degree_u()) * (2.0 * few + data.degree_v());
  worth.control_points = size * std::pow(std::max(fine_probe.error, 1e-300) / tolerance.value,
                                         2 / order(coarse.optimised, fine_probe.optimised));
  return worth;
}

}  // namespace knotfit
