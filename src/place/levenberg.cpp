#include "place/levenberg.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/scattered.h"
namespace knotfit {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

SpacingStep::SpacingStep(FitProblem& problem, const InteriorKnots& knots, bool golub_pereyra,
                         double scale_matrix, double scale_gradient)
    : u_(knots.u), v_(knots.v), unknowns_(u_.length.size() + v_.length.size()) {
  const KnotJacobian jacobian = problem.scattered().knot_jacobian(problem.net(), golub_pereyra);
  const auto k = static_cast<Index>(jacobian.knots), n = static_cast<Index>(unknowns_);
  std::vector<double> chain(jacobian.knots * unknowns_, 0.0);
  u_.chain(chain, 0, 0, unknowns_);
  v_.chain(chain, knots.u.size(), u_.length.size(), unknowns_);
  const Eigen::Map<const RowMajor> c(chain.data(), k, n), h(jacobian.matrix.data(), k, k);
  const Eigen::Map<const Eigen::VectorXd> g(jacobian.gradient.data(), k);
  matrix_.resize(unknowns_ * unknowns_);
  gradient_.resize(unknowns_);
  step_.assign(unknowns_, 0.0);
  Eigen::Map<RowMajor>(matrix_.data(), n, n).noalias() = c.transpose() * (h * c) * scale_matrix;
  Eigen::Map<Eigen::VectorXd>(gradient_.data(), n).noalias() = c.transpose() * g * scale_gradient;
}

bool SpacingStep::solve(double mu, double most) {
  const auto n = static_cast<Index>(unknowns_);
  const Eigen::Map<const RowMajor> h(matrix_.data(), n, n);
  const Eigen::Map<const Eigen::VectorXd> g(gradient_.data(), n);
  Eigen::Map<Eigen::VectorXd> s(step_.data(), n);
  const double trace = h.trace();
  Eigen::MatrixXd damped = h;
  damped.diagonal().array() +=
      mu * (h.diagonal().array() + 1e-6 * trace / static_cast<double>(n)) + 1e-13 * trace;
  s = -damped.ldlt().solve(g);
  const double largest = s.cwiseAbs().maxCoeff();
  if (!std::isfinite(largest)) return false;
  if (largest > most) s *= most / largest;
  return true;
}

InteriorKnots SpacingStep::moved(double least_span) const {
  return {u_.moved(step_.data(), least_span).knots(),
          v_.moved(step_.data() + u_.length.size(), least_span).knots()};
}

double SpacingStep::predicted_fall() const {
  const auto n = static_cast<Index>(unknowns_);
  const Eigen::Map<const Eigen::VectorXd> s(step_.data(), n), g(gradient_.data(), n);
  return -(2 * s.dot(g) + s.dot(Eigen::Map<const RowMajor>(matrix_.data(), n, n) * s));
}

double minimize_over_knots(FitProblem& problem, InteriorKnots& knots, const LevenbergOptions& options) {
  if (!problem.solve(knots)) return std::numeric_limits<double>::infinity();
  double phi = problem.phi(), mu = 1e-2, growth = 2;
  if (knots.u.empty() && knots.v.empty()) return phi;
  int small_falls = 0;
  for (int step = 0; step < options.steps && phi > 0; ++step) {
    if (options.stop && options.stop()) break;
    SpacingStep model(problem, knots, options.golub_pereyra);
    bool accepted = false;
    double fall = 0;
    for (int refused = 0; refused < 10; ++refused) {
      if (!model.solve(mu, 1.0)) {
        mu *= 4;
        continue;
      }
      const InteriorKnots trial = model.moved(options.least_span);
      const double predicted = model.predicted_fall();
      if (problem.solve(trial) && problem.phi() < phi) {
        const double rho = predicted > 0 ? (phi - problem.phi()) / predicted : 0;
        fall = (phi - problem.phi()) / phi;
        phi = problem.phi();
        knots = trial;
        accepted = true;
        mu = std::max(1e-9, mu * std::max(0.1, 1 - std::pow(2 * std::min(rho, 1.0) - 1, 3)));
        growth = 2;
        break;
      }
      mu *= growth;
      growth = std::min(2 * growth, 64.0);
      if (predicted < 1e-3 * options.fall * phi && refused > 1) break;
    }
    if (!accepted) {
      problem.solve(knots);
      break;
    }
    small_falls = fall < options.fall ? small_falls + 1 : 0;
    if (small_falls >= 2 || (step > 1 && phi * (1 - 5 * fall) > options.target && options.target > 0)) break;
  }
  return phi;
}

}  // namespace knotfit
