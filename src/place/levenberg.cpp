#include "place/levenberg.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "place/damped_step.h"
namespace knotfit {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

SpacingStep::SpacingStep(const KnotJacobian& jacobian, const InteriorKnots& knots)
    : SpacingStep(jacobian, knots, std::nullopt) {}

SpacingStep::SpacingStep(MovingFit& problem, const InteriorKnots& knots, bool golub_pereyra,
                         double scale_matrix, double scale_gradient)
    : SpacingStep(problem.jacobian(golub_pereyra), knots, Scales{scale_matrix, scale_gradient}) {}

SpacingStep::SpacingStep(const KnotJacobian& jacobian, const InteriorKnots& knots,
                         std::optional<Scales> scales)
    : u_(knots.u), v_(knots.v), unknowns_(u_.length.size() + v_.length.size()) {
  const auto k = static_cast<Index>(jacobian.knots), n = static_cast<Index>(unknowns_);
  std::vector<double> chain(jacobian.knots * unknowns_, 0.0);
  u_.chain(chain, 0, 0, unknowns_);
  v_.chain(chain, knots.u.size(), u_.length.size(), unknowns_);
  const Eigen::Map<const RowMajor> c(chain.data(), k, n), h(jacobian.matrix.data(), k, k);
  const Eigen::Map<const Eigen::VectorXd> g(jacobian.gradient.data(), k);
  matrix_.resize(unknowns_ * unknowns_);
  gradient_.resize(unknowns_);
  step_.assign(unknowns_, 0.0);
  Eigen::Map<RowMajor> matrix(matrix_.data(), n, n);
  Eigen::Map<Eigen::VectorXd> gradient(gradient_.data(), n);
  if (scales) {
    matrix.noalias() = c.transpose() * (h * c) * scales->matrix;
    gradient.noalias() = c.transpose() * g * scales->gradient;
  } else {  // a scale of 1 sums in another order: other last bits
    matrix.noalias() = c.transpose() * (h * c);
    gradient.noalias() = c.transpose() * g;
  }
}

bool SpacingStep::solve(double mu, double most) {
  return damped_step(matrix_, gradient_, mu, most, step_);
}

InteriorKnots SpacingStep::moved(double least_span) const {
  return {u_.moved(step_.data(), least_span).knots(),
          v_.moved(step_.data() + u_.length.size(), least_span).knots()};
}

double SpacingStep::predicted_fall() const {
  return knotfit::predicted_fall(matrix_, gradient_, step_);
}

double minimize_over_knots(MovingFit& problem, InteriorKnots& knots, const LevenbergOptions& options) {
  if (!problem.solve(knots)) return std::numeric_limits<double>::infinity();
  double phi = problem.phi();
  Damping damping;
  if (knots.u.empty() && knots.v.empty()) return phi;
  int small_falls = 0;
  for (int step = 0; step < options.steps && phi > 0; ++step) {
    if (options.stop && options.stop()) break;
    SpacingStep model(problem, knots, options.golub_pereyra);
    double fall = 0;
    for (int refused = 0; refused < 10; ++refused) {
      if (!model.solve(damping.mu, 1.0)) {
        damping.mu *= 4;
        continue;
      }
      const double predicted = model.predicted_fall();
      fall = take_if_lower(problem, model.moved(options.least_span), predicted, knots, phi, damping);
      if (fall > 0 || (predicted < 1e-3 * options.fall * phi && refused > 1)) break;
    }
    if (!(fall > 0)) {
      problem.solve(knots);
      break;
    }
    small_falls = fall < options.fall ? small_falls + 1 : 0;
    if (small_falls >= 2 || (step > 1 && phi * (1 - 5 * fall) > options.target && options.target > 0)) break;
  }
  return phi;
}

}  // namespace knotfit
