// One step of Levenberg-Marquardt: the damped normal equations, and how the damping follows the steps [Nielsen99; METHOD 3.2].
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
namespace knotfit {

/// The damping mu: down after a step that keeps what the quadratic model predicted, up faster and faster after refusals.
struct Damping {
  double mu = 1e-2, growth = 2;
  /// \param gain  the fall of phi over the fall predicted
  void accept(double gain) {
    mu = std::max(1e-9, mu * std::max(0.1, 1 - std::pow(2 * std::min(gain, 1.0) - 1, 3)));
    growth = 2;
  }
  void refuse() {
    mu *= growth;
    growth = std::min(2 * growth, 64.0);
  }
};

/// step = -(H + mu (diag H + 1e-6 mean diag H) + 1e-13 trace H)^-1 g, shortened to no entry beyond `most`.
/// \param matrix  H, n x n, symmetric
/// \return false where the matrix is singular
bool damped_step(std::span<const double> matrix, std::span<const double> gradient, double mu, double most,
                 std::span<double> step);

/// Of the quadratic model: -(2 g.s + s.H s).
double predicted_fall(std::span<const double> matrix, std::span<const double> gradient,
                      std::span<const double> step);

/// Takes the trial where its fit lowers phi; the damping follows. The problem holds the fit of the trial either way.
/// \param predicted  by the quadratic model   \return the relative fall of phi; 0: refused
template <class Problem, class Knots>
double take_if_lower(Problem& problem, const Knots& trial, double predicted, Knots& knots, double& phi,
                     Damping& damping) {
  if (!problem.solve(trial) || !(problem.phi() < phi)) {
    damping.refuse();
    return 0;
  }
  damping.accept(predicted > 0 ? (phi - problem.phi()) / predicted : 0);
  const double fall = (phi - problem.phi()) / phi;
  phi = problem.phi();
  knots = trial;
  return fall;
}

}  // namespace knotfit
