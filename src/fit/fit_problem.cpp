#include "fit/fit_problem.h"

#include <cmath>
#include <limits>

#include "fit/error_measure.h"
#include "knotfit/exceptions.h"
#include "solve/banded_system.h"
#include "solve/kronecker_system.h"
#include "solve/smoothing_floor.h"
namespace knotfit {

GridLayout fitted_grid(const ParameterizedPoints& points) {
  return points.weights.empty() ? find_grid(points) : GridLayout{};
}

FitProblem::FitProblem(const ParameterizedPoints& points, int degree_u, int degree_v,
                       const LeastSquaresOptions& options)
    : points_(points),
      degree_u_(degree_u),
      degree_v_(degree_v),
      options_(options),
      counted_(points.size()),
      u_(degree_u),
      v_(degree_v) {
  validate(points);
  most_u_ = most_v_ = points.size();
  if (!(options.smoothing >= 0) || !std::isfinite(options.smoothing))
    throw InvalidInput("the smoothing floor must be finite and at least 0");
  if (options.use_grid)
    if (GridLayout grid = fitted_grid(points); !grid.empty()) {
      on_grid_ = true;
      most_u_ = static_cast<Index>(grid.u.size());
      most_v_ = static_cast<Index>(grid.v.size());
      system_ = std::make_unique<KroneckerSystem>(points, std::move(grid));
    }
  if (!system_) system_ = std::make_unique<BandedSystem>(points, options.energy);
  system_->keep_norm(options.estimate_condition);
}

void FitProblem::set_knots(const InteriorKnots& knots) {
  knots_ = knots;
  u_ = Axis(degree_u_, knots.u);
  v_ = Axis(degree_v_, knots.v);
}

void FitProblem::evaluate(const InteriorKnots& knots, std::vector<double> net) {
  set_knots(knots);
  net_ = std::move(net);
  system_->arrange(u_, v_);
  take(system_->residuals(net_));
}

std::vector<double> FitProblem::errors() const {
  std::vector<double> errors = system_->errors();
  errors.resize(static_cast<std::size_t>(counted_));
  return errors;
}

void FitProblem::take(const ResidualSums& sums) {
  rms_ = std::sqrt(sums.squares / static_cast<double>(counted_));
  max_ = sums.max;
  phi_ = sums.weighted;
}

bool FitProblem::solve(const InteriorKnots& knots) {
  ++fits_;
  set_knots(knots);
  rms_ = max_ = phi_ = std::numeric_limits<double>::infinity();
  net_.clear();
  const bool solved = with_smoothing_floor(options_.smoothing, [&](double floor) {
    if (!system_->factor(u_, v_, floor)) return false;
    net_ = system_->project_data();
    ResidualSums sums = system_->residuals(net_);
    for (int step = 0; step < options_.refinement_steps && std::isfinite(sums.squares); ++step) {
      const std::vector<double> correction = system_->project_residual();
      for (std::size_t i = 0; i < net_.size(); ++i) net_[i] -= correction[i];
      sums = system_->residuals(net_);
    }
    take(sums);
    bool finite = std::isfinite(rms_) && std::isfinite(max_);
    for (std::size_t i = 0; i < net_.size() && finite; ++i) finite = std::isfinite(net_[i]);
    return finite;
  });
  if (!solved) rms_ = max_ = phi_ = std::numeric_limits<double>::infinity();
  return solved;
}

double FitProblem::operations(Index functions_u, Index functions_v) const {
  const double points = static_cast<double>(points_.size()) * points_.dimension;
  const double m = degree_u_, n = degree_v_;
  if (on_grid_) return points * (4 * m + 4 * n + 16);
  // Moments and residuals of every point, then a banded Cholesky factor.
  const double inner = static_cast<double>(std::min(functions_u, functions_v));
  const double outer = static_cast<double>(std::max(functions_u, functions_v));
  const double band = std::max(m, n) * inner;
  return points * (2 * (2 * m + 1) * (2 * n + 1) + 6 * (m + 1) * (n + 1)) + inner * outer * band * band;
}

Surface FitProblem::surface() const {
  return Surface(u_.knots(), v_.knots(), points_.dimension, net_);
}

double FitProblem::measured(const Tolerance& tolerance) const {
  const ErrorMeasureRow& row = row_of(tolerance.measure);
  if (row.of_sums) return row.of_sums(rms_, max_);
  return std::isfinite(max_) ? row.of_errors(errors(), tolerance.share) : max_;
}

}  // namespace knotfit
