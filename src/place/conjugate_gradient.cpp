#include <algorithm>
#include <cmath>

#include "place/context.h"
#include "place/free_net.h"
#include "place/knot_spacings.h"
#include "place/shares.h"
namespace knotfit {
namespace {

using Vector = std::vector<double>;

/// Control points, then log-spacings, as one vector of unknowns scaled to like curvature.
class Unknowns {
 public:
  Unknowns(const FitProblem& problem, InteriorKnots knots, Vector net)
      : problem_(&problem), knots_(std::move(knots)), net_(std::move(net)) {
    const Axis u(problem.degree_u(), knots_.u), v(problem.degree_v(), knots_.v);
    const Vector weight = net_row_sums(problem.points(), u, v);
    const int d = problem.points().dimension;
    double mean = 0;
    for (double w : weight) mean += w / static_cast<double>(weight.size());
    scale_.resize(net_.size());
    for (std::size_t i = 0; i < net_.size(); ++i)
      scale_[i] = 1 / std::sqrt(std::max(weight[i / d], 1e-3 * mean));
  }
  const InteriorKnots& knots() const { return knots_; }

  double value() const { return evaluate(false).phi; }
  double value_and_gradient(Vector& gradient) const {
    const FreeNet at = evaluate(true);
    gradient = at.by_net;
    for (std::size_t i = 0; i < net_.size(); ++i) gradient[i] *= scale_[i];
    const Vector spacings = by_log_spacings(knots_, at.by_knots);
    gradient.insert(gradient.end(), spacings.begin(), spacings.end());
    return at.phi;
  }
  Unknowns moved(const Vector& direction, double t) const {
    Unknowns result = *this;
    for (std::size_t i = 0; i < net_.size(); ++i) result.net_[i] += t * scale_[i] * direction[i];
    Vector step(direction.begin() + static_cast<Index>(net_.size()), direction.end());
    for (double& x : step) x *= t;
    result.knots_ = moved_knots(knots_, step.data(), 0.01);
    return result;
  }
  /// Largest move of a log-spacing.
  double knot_step(const Vector& direction) const {
    double largest = 0;
    for (std::size_t i = net_.size(); i < direction.size(); ++i)
      largest = std::max(largest, std::abs(direction[i]));
    return largest;
  }

 private:
  FreeNet evaluate(bool with_knots) const {
    return free_net(problem_->points(), Axis(problem_->degree_u(), knots_.u),
                    Axis(problem_->degree_v(), knots_.v), net_, with_knots);
  }
  const FitProblem* problem_;
  InteriorKnots knots_;
  Vector net_, scale_;
};

}  // namespace

/// Knots and control points together by nonlinear conjugate gradients, after [Xie01], who minimise an energy
/// over all degrees of freedom of a NURBS by a general gradient method. Steps, ours where the paper leaves them:
///  1. start: uniform knots and their least squares;
///  2. unknowns: control points scaled by the roots of the row sums of A^T W A, and log-spacings of the knots;
///  3. directions of Polak and Ribiere, restarted where they do not descend; backtracking line search (Armijo) with a
///     first try by a parabola;
///  4. at most 300 steps, or five of a relative fall below 1e-6; least squares at the knots reached ends it.
Placement place_conjugate_gradient(PlacementContext& context, int interior_u, int interior_v) {
  FitProblem& problem = context.problem();
  const InteriorKnots uniform{uniform_knots(interior_u), uniform_knots(interior_v)};
  Placement placement;
  placement.knots = uniform;
  placement.status = PlacementStatus::converged;
  if (!problem.solve(uniform)) return placement;

  Unknowns x(problem, uniform, problem.net());
  Vector gradient, direction, before;
  double phi = x.value_and_gradient(gradient), last = 1;
  int small = 0;
  for (int step = 0; step < 300 && phi > 0 && small < 5; ++step) {
    if (context.stop_requested()) break;
    double beta = 0;
    if (!direction.empty()) {
      Vector change = gradient;
      for (std::size_t i = 0; i < change.size(); ++i) change[i] -= before[i];
      beta = std::max(0.0, dot(gradient, change) / dot(before, before));
    }
    if (direction.empty()) direction.assign(gradient.size(), 0.0);
    for (std::size_t i = 0; i < gradient.size(); ++i) direction[i] = beta * direction[i] - gradient[i];
    double slope = dot(direction, gradient);
    if (!(slope < 0)) {
      for (std::size_t i = 0; i < gradient.size(); ++i) direction[i] = -gradient[i];
      slope = -dot(gradient, gradient);
    }
    if (!(slope < 0)) break;  // the gradient is zero
    const double reach = x.knot_step(direction);
    double t = reach > 0 ? std::min(2 * last, 0.5 / reach) : 2 * last;
    bool moved = false;
    for (int trial = 0; trial < 30; ++trial) {
      const Unknowns there = x.moved(direction, t);
      const double after = there.value();
      if (after <= phi + 1e-4 * t * slope) {
        small = phi - after < 1e-6 * phi ? small + 1 : 0;
        x = there;
        moved = true;
        break;
      }
      // The parabola through both values and the slope, kept within a tenth to a half.
      const double vertex = -slope * t * t / (2 * (after - phi - slope * t));
      t = std::isfinite(vertex) ? std::clamp(vertex, 0.1 * t, 0.5 * t) : 0.1 * t;
    }
    if (!moved) break;
    last = t;
    before = gradient;
    phi = x.value_and_gradient(gradient);
  }
  placement.knots = x.knots();
  if (context.stop_requested()) placement.status = PlacementStatus::stopped;
  return placement;
}

}  // namespace knotfit
