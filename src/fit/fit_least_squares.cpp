#include "knotfit/fit_least_squares.h"

#include <fmt/format.h>

#include <cmath>

#include "fit/fit_problem.h"
#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
#include "solve/data_energy.h"
namespace knotfit {

std::shared_ptr<const DataEnergy> make_data_energy(const ParameterizedPoints& points, double scale,
                                                   std::shared_ptr<const IndexedPoints> indexed) {
  validate(points);
  if (!(scale > 0) || !std::isfinite(scale))
    throw InvalidInput(fmt::format("a data energy for errors of {}: it must be positive and finite", scale));
  return std::make_shared<const DataEnergy>(data_raster(points, scale, std::move(indexed)));
}

LeastSquaresResult fit_least_squares(const ParameterizedPoints& points, const KnotVector& knots_u,
                                     const KnotVector& knots_v, const LeastSquaresOptions& options) {
  for (const KnotVector* k : {&knots_u, &knots_v})
    if (!k->is_clamped() || k->first() != 0 || k->last() != 1)
      throw InvalidInput("a fit needs clamped knot vectors on [0,1]");
  if (points.size() < knots_u.size() * knots_v.size())
    throw InvalidInput(
        fmt::format("{} points are fewer than {} x {} = {} control points; ask for fewer control points or a "
                    "lower {}",
                    points.size(), knots_u.size(), knots_v.size(), knots_u.size() * knots_v.size(),
                    remedy_text(Remedy::degree)));
  FitProblem problem(points, knots_u.degree(), knots_v.degree(), options);
  LeastSquaresResult result;
  result.on_grid = problem.on_grid();
  if (!problem.solve({knots_u.interior(), knots_v.interior()})) {
    result.status = FitStatus::singular;
    return result;
  }
  result.status = FitStatus::solved;
  result.surface = problem.surface();
  result.errors = problem.errors();
  result.error = summarize_errors(result.errors, points);
  result.smoothing = problem.smoothing();
  result.empty_cells = problem.empty_cells();
  if (options.estimate_condition) result.condition = problem.condition();
  return result;
}

}  // namespace knotfit
