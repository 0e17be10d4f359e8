#include "fit/problem.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "fit/gridded.h"
#include "fit/scattered.h"
#include "knotfit/exceptions.h"
namespace knotfit {

FitProblem::FitProblem(const ParameterizedPoints& points, int degree_u, int degree_v,
                       const LeastSquaresOptions& options)
    : points_(points),
      degree_u_(degree_u),
      degree_v_(degree_v),
      options_(options),
      u_(degree_u),
      v_(degree_v) {
  validate(points);
  most_u_ = most_v_ = points.size();
  if (!(options.smoothing >= 0) || !std::isfinite(options.smoothing))
    throw InvalidInput("the smoothing floor must be finite and at least 0");
  if (options.use_grid && points.weights.empty())
    if (GridLayout grid = find_grid(points); !grid.empty()) {
      on_grid_ = true;
      most_u_ = static_cast<Index>(grid.u.size());
      most_v_ = static_cast<Index>(grid.v.size());
      backend_ = std::make_unique<GriddedBackend>(points, std::move(grid));
    }
  if (!backend_) {
    auto scattered = std::make_unique<ScatteredBackend>(points, options.energy);
    scattered_ = scattered.get();
    backend_ = std::move(scattered);
  }
  backend_->keep_norm(options.estimate_condition);
}

FitProblem::~FitProblem() = default;

ScatteredBackend& FitProblem::scattered() {
  if (!scattered_) throw std::logic_error("knots move on scattered points only");
  return *scattered_;
}

void FitProblem::take_new_points() {
  scattered().append(points_, scattered().points().size());
}

bool FitProblem::factor(const InteriorKnots& knots) {
  ++fits_;
  knots_ = knots;
  u_ = Axis(degree_u_, knots.u);
  v_ = Axis(degree_v_, knots.v);
  return backend_->factor(u_, v_, options_.smoothing);
}

void FitProblem::evaluate(const InteriorKnots& knots, std::vector<double> net) {
  knots_ = knots;
  u_ = Axis(degree_u_, knots.u);
  v_ = Axis(degree_v_, knots.v);
  net_ = std::move(net);
  scattered().arrange(u_, v_);
  take(backend_->residuals(net_));
}

std::vector<double> FitProblem::errors() const {
  std::vector<double> errors = backend_->errors();
  if (scattered_) errors.resize(static_cast<std::size_t>(scattered_->counted()));
  return errors;
}

void FitProblem::restore(std::vector<double> net, std::vector<double> residual) {
  net_ = std::move(net);
  take(scattered().set_residual(std::move(residual)));
}

void FitProblem::take(const ResidualSums& sums) {
  const Index counted = scattered_ ? scattered_->counted() : points_.size();
  rms_ = std::sqrt(sums.squares / static_cast<double>(counted));
  max_ = sums.max;
  phi_ = sums.weighted;
}

bool FitProblem::solve(const InteriorKnots& knots) {
  ++fits_;
  knots_ = knots;
  u_ = Axis(degree_u_, knots.u);
  v_ = Axis(degree_v_, knots.v);
  rms_ = max_ = phi_ = std::numeric_limits<double>::infinity();
  net_.clear();
  // Rounding can beat a very small floor: raise it rather than give up, and report what was used.
  // A floor of the caller's own beyond what is raised to is tried as it is.
  const double most = std::max(options_.smoothing, 1e-5);
  bool solved = false;
  for (double floor = options_.smoothing; !solved && floor <= most; floor = std::max(100 * floor, 1e-12)) {
    if (!backend_->factor(u_, v_, floor)) continue;
    net_ = backend_->project_data();
    ResidualSums sums = backend_->residuals(net_);
    for (int step = 0; step < options_.refinement_steps && std::isfinite(sums.squares); ++step) {
      const std::vector<double> correction = backend_->project_residual();
      for (std::size_t i = 0; i < net_.size(); ++i) net_[i] -= correction[i];
      sums = backend_->residuals(net_);
    }
    take(sums);
    solved = std::isfinite(rms_) && std::isfinite(max_);
    for (std::size_t i = 0; i < net_.size() && solved; ++i) solved = std::isfinite(net_[i]);
  }
  if (!solved) rms_ = max_ = phi_ = std::numeric_limits<double>::infinity();
  return solved;
}

double FitProblem::work(Index functions_u, Index functions_v) const {
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
  switch (tolerance.measure) {
    case ErrorMeasure::max:
      return max_;
    case ErrorMeasure::rms:
      return rms_;
    case ErrorMeasure::percentile:
      break;
  }
  return std::isfinite(max_) ? error_quantile(errors(), tolerance.share) : max_;
}

}  // namespace knotfit
