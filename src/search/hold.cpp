#include <algorithm>

#include "base/deadline.h"
#include "fit/error_measure.h"
#include "fit/fit_problem.h"
#include "search/routes.h"
#include "verify/swings.h"
namespace knotfit {
namespace {

constexpr double kMostOperations = 1e10;  // of a fit, about a second: larger nets are not held

}  // namespace

std::shared_ptr<const DataEnergy> own_energy(const ParameterizedPoints& points, const Tolerance& tolerance,
                                             double error, std::shared_ptr<const IndexedPoints> indexed) {
  return make_data_energy(points, std::max(error, energy_scale(tolerance)), std::move(indexed));
}

double energy_scale(const Tolerance& tolerance) {
  return row_of(tolerance.measure).energy_scale * tolerance.value;
}

void hold(RefineResult& result, const ParameterizedPoints& points, const RefineOptions& options,
          const Control& control) {
  LeastSquaresOptions fit = search_fits(options);
  const Deadline deadline(control);
  const auto cut = [&] {
    if (deadline.over()) result.status = deadline.stopped() ? Status::stopped : Status::time_limit;
    return result.status == Status::stopped || result.status == Status::time_limit;
  };
  for (const InteriorKnots& knots : {result.nearest, result.knots}) {
    fit.energy = options.energy;
    FitProblem problem(points, options.degree_u, options.degree_v, fit);
    const double operations = problem.operations(static_cast<Index>(knots.u.size()) + options.degree_u + 1,
                                                 static_cast<Index>(knots.v.size()) + options.degree_v + 1);
    if (operations > kMostOperations || cut() || !problem.solve(knots)) continue;
    for (const double times : {1.0, 4.0}) {
      if (cut()) return;
      fit.energy = own_energy(points, options.tolerance, times * problem.rms(), options.sites->indexed());
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

}  // namespace knotfit
