#include "place/periodic.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "place/damped_step.h"
#include "place/knot_spacings.h"
namespace knotfit {
namespace {

constexpr double kLeastSpan = 0.005;  // of the mean, as levenberg.h

/// The seam, and the spans from it on.
struct Period {
  double seam;
  std::vector<double> length;
  explicit Period(const std::vector<double>& knots) : seam(knots.front()) {
    for (std::size_t i = 0; i < knots.size(); ++i)
      length.push_back((i + 1 < knots.size() ? knots[i + 1] : knots.front() + 1) - knots[i]);
  }
  /// step: log-spacings, then the seam's move in mean spans.
  std::vector<double> moved(const Eigen::VectorXd& step) const {
    std::vector<double> h = length;
    double sum = 0;
    for (std::size_t i = 0; i < h.size(); ++i) sum += h[i] *= std::exp(step[static_cast<Index>(i)]);
    for (double& x : h) x /= sum;
    raise_lengths(h, kLeastSpan);
    const double at = seam + step[static_cast<Index>(h.size())] / static_cast<double>(h.size());
    std::vector<double> knots{at - std::floor(at)};
    for (std::size_t i = 0; i + 1 < h.size(); ++i) knots.push_back(knots.back() + h[i]);
    return knots;
  }
};

Eigen::VectorXd residual(const CurveProblem& problem) {
  return Eigen::Map<const Eigen::VectorXd>(problem.residual().data(),
                                           static_cast<Index>(problem.residual().size()));
}

double descend(CurveProblem& problem, std::vector<double>& knots, int steps,
               const std::function<bool()>& stop) {
  if (!problem.solve(knots)) return std::numeric_limits<double>::infinity();
  double phi = problem.phi();
  Damping damping;
  const Index unknowns = static_cast<Index>(knots.size()) + 1;
  int small = 0;
  for (int step = 0; step < steps && phi > 0 && small < 2; ++step) {
    if (stop && stop()) break;
    const Period period(knots);
    const Eigen::VectorXd r = residual(problem);
    Eigen::MatrixXd jacobian(r.size(), unknowns);
    constexpr double kStep = 1e-6;
    for (Index i = 0; i < unknowns; ++i) {
      Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns);
      x[i] = kStep;
      if (problem.solve(period.moved(x)))
        jacobian.col(i) = (residual(problem) - r) / kStep;
      else
        jacobian.col(i).setZero();
    }
    const Eigen::MatrixXd h = jacobian.transpose() * jacobian;
    const Eigen::VectorXd g = jacobian.transpose() * r;
    const auto n = static_cast<std::size_t>(unknowns);
    const std::span<const double> matrix(h.data(), n * n), gradient(g.data(), n);
    Eigen::VectorXd s(unknowns);
    const std::span<double> unknown(s.data(), n);
    double fall = 0;
    for (int refused = 0; refused < 10 && !(fall > 0); ++refused) {
      if (!damped_step(matrix, gradient, damping.mu, 1, unknown)) break;
      fall = take_if_lower(problem, period.moved(s), predicted_fall(matrix, gradient, unknown), knots, phi,
                           damping);
    }
    if (!(fall > 0)) break;
    small = fall < 1e-4 ? small + 1 : 0;
  }
  problem.solve(knots);
  return phi;
}

/// All but one; the first of them in [0,1), where a problem looks for it.
std::vector<double> without(std::vector<double> knots, std::size_t dropped) {
  knots.erase(knots.begin() + static_cast<Index>(dropped));
  if (knots.front() >= 1)
    for (double& x : knots) x -= 1;
  return knots;
}

/// Drops a knot and puts one into the middle of the span with the largest residuals.
std::vector<double> relocated(CurveProblem& problem, const std::vector<double>& knots, std::size_t dropped) {
  std::vector<double> rest = without(knots, dropped);
  if (!problem.solve(rest)) return knots;
  const CurvePoints& points = problem.points();
  std::vector<double> squares(rest.size(), 0.0);
  for (Index k = 0; k < points.size(); ++k) {
    const double t = problem.on_curve(points.t[k]);
    const auto s = std::upper_bound(rest.begin(), rest.end(), t) - rest.begin() - 1;
    for (int e = 0; e < points.dimension; ++e) {
      const double r = problem.residual()[k * points.dimension + e];
      squares[s] += r * r;
    }
  }
  const std::size_t s =
      static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const double end = s + 1 < rest.size() ? rest[s + 1] : rest.front() + 1;
  rest.insert(rest.begin() + static_cast<Index>(s) + 1, (rest[s] + end) / 2);
  return rest;
}

}  // namespace

double optimize_period(CurveProblem& problem, std::vector<double>& knots, const std::function<bool()>& stop) {
  double phi = descend(problem, knots, 40, stop);
  for (int pass = 0; pass < 8 && knots.size() > static_cast<std::size_t>(problem.degree()) + 1; ++pass) {
    if (stop && stop()) break;
    std::vector<double> loss;
    for (std::size_t i = 0; i < knots.size(); ++i) {
      problem.solve(without(knots, i));
      loss.push_back(problem.phi());
    }
    std::vector<std::size_t> order(loss.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return loss[a] < loss[b]; });
    order.resize(std::min<std::size_t>(order.size(), 3));
    bool moved = false;
    for (std::size_t dropped : order) {
      std::vector<double> trial = relocated(problem, knots, dropped);
      if (const double after = descend(problem, trial, 40, stop); after < phi * (1 - 1e-3)) {
        phi = after;
        knots = trial;
        moved = true;
        break;
      }
    }
    if (!moved) break;
  }
  problem.solve(knots);
  return phi;
}

}  // namespace knotfit
