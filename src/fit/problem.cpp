#include "fit/problem.h"

#include <cmath>
#include <limits>

#include "fit/gridded.h"
#include "fit/scattered.h"
#include "knotfit/errors.h"
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
  if (!(options.smoothing >= 0) || !std::isfinite(options.smoothing))
    throw InvalidInput("the smoothing floor must be finite and at least 0");
  if (options.use_grid && points.weights.empty())
    if (GridLayout grid = find_grid(points); !grid.empty()) {
      on_grid_ = true;
      backend_ = std::make_unique<GriddedBackend>(points, std::move(grid));
    }
  if (!backend_) backend_ = std::make_unique<ScatteredBackend>(points);
  backend_->keep_norm(options.estimate_condition);
}

FitProblem::~FitProblem() = default;

bool FitProblem::solve(const InteriorKnots& knots) {
  ++fits_;
  knots_ = knots;
  u_ = Axis(degree_u_, knots.u);
  v_ = Axis(degree_v_, knots.v);
  rms_ = max_ = std::numeric_limits<double>::infinity();
  net_.clear();
  // Rounding can beat a very small floor: raise it rather than give up, and report what was used.
  bool solved = false;
  for (double floor = options_.smoothing; !solved && floor <= 1e-5; floor = std::max(100 * floor, 1e-12)) {
    if (!backend_->factor(u_, v_, floor)) continue;
    net_ = backend_->project_data();
    ResidualSums sums = backend_->residuals(net_);
    for (int step = 0; step < options_.refinement_steps && std::isfinite(sums.squares); ++step) {
      const std::vector<double> correction = backend_->project_residual();
      for (std::size_t i = 0; i < net_.size(); ++i) net_[i] -= correction[i];
      sums = backend_->residuals(net_);
    }
    rms_ = std::sqrt(sums.squares / static_cast<double>(points_.size()));
    max_ = sums.max;
    solved = std::isfinite(rms_) && std::isfinite(max_);
    for (std::size_t i = 0; i < net_.size() && solved; ++i) solved = std::isfinite(net_[i]);
  }
  if (!solved) rms_ = max_ = std::numeric_limits<double>::infinity();
  return solved;
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
