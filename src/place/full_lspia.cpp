#include "place/full_lspia.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "place/context.h"
#include "place/free_net.h"
#include "place/knot_spacings.h"
#include "place/row_knots.h"
#include "place/shares.h"
namespace knotfit {
namespace {

using Vector = std::vector<double>;

/// Two-loop recursion over the last moves of the knots [Nocedal06 7.4].
class Lbfgs {
 public:
  Vector direction(const Vector& gradient) const {
    Vector q = gradient;
    std::vector<double> alpha(pairs_.size());
    for (std::size_t i = pairs_.size(); i-- > 0;) {
      const auto& [s, y] = pairs_[i];
      alpha[i] = dot(s, q) / dot(s, y);
      for (std::size_t c = 0; c < q.size(); ++c) q[c] -= alpha[i] * y[c];
    }
    if (!pairs_.empty()) {
      const auto& [s, y] = pairs_.back();
      for (double& x : q) x *= dot(s, y) / dot(y, y);
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const auto& [s, y] = pairs_[i];
      const double beta = dot(y, q) / dot(s, y);
      for (std::size_t c = 0; c < q.size(); ++c) q[c] += (alpha[i] - beta) * s[c];
    }
    for (double& x : q) x = -x;
    return q;
  }
  void learn(Vector s, Vector y) {
    if (!(dot(s, y) > 1e-12 * dot(y, y))) return;  // no curvature to learn from
    pairs_.push_back({std::move(s), std::move(y)});
    if (pairs_.size() > 6) pairs_.pop_front();
  }
  void forget() { pairs_.clear(); }

 private:
  std::deque<std::pair<Vector, Vector>> pairs_;
};

InteriorKnots moved(const InteriorKnots& knots, const Vector& step, double scale, double least_span) {
  Vector s = step;
  for (double& x : s) x *= scale;
  return moved_knots(knots, s.data(), least_span);
}

struct Axes {
  Axis u, v;
  Axes(const FitProblem& p, const InteriorKnots& k) : u(p.degree_u(), k.u), v(p.degree_v(), k.v) {}
};

}  // namespace

std::vector<double> full_lspia(FitProblem& problem, InteriorKnots& knots, const FullLspiaOptions& options) {
  if (!problem.solve(knots)) return {};
  const ParameterizedPoints& points = problem.points();
  const int d = points.dimension;
  Vector net = problem.net();
  std::vector<double> history{problem.phi()};
  Lbfgs memory;
  Vector before_gradient, step;
  int small = 0;
  for (int round = 0; round < options.rounds && history.back() > 0; ++round) {
    if (options.stop && options.stop()) break;
    Axes axes(problem, knots);
    // Control points: each moves by the residuals it feels over the sum of what it weighs, a step that never raises
    // phi: the largest eigenvalue of D^-1 A^T W A is at most 1 [Deng14].
    const Vector weight = net_row_sums(points, axes.u, axes.v);
    FreeNet at;
    double phi = history.back();
    for (int s = 0; s <= options.net_steps; ++s) {
      at = free_net(points, axes.u, axes.v, net, s == options.net_steps);
      phi = at.phi;
      if (s == options.net_steps) break;
      for (std::size_t i = 0; i < net.size(); ++i)
        if (weight[i / d] > 0) net[i] -= at.by_net[i] / 2 / weight[i / d];
    }
    // Knots: L-BFGS in their log-spacings at these control points.
    const Vector gradient = by_log_spacings(knots, at.by_knots);
    if (!step.empty()) {
      Vector y = gradient;
      for (std::size_t i = 0; i < y.size(); ++i) y[i] -= before_gradient[i];
      memory.learn(step, std::move(y));
    }
    step.clear();
    Vector direction = memory.direction(gradient);
    if (!(dot(direction, gradient) < 0)) {
      memory.forget();
      direction = memory.direction(gradient);
    }
    double largest = 0;
    for (double x : direction) largest = std::max(largest, std::abs(x));
    double t = largest > 0 ? std::min(1.0, 0.5 / largest) : 0;
    for (int halving = 0; halving < 20 && t > 0; ++halving, t /= 2) {
      const InteriorKnots trial = moved(knots, direction, t, options.least_span);
      const Axes there(problem, trial);
      const double after = free_net(points, there.u, there.v, net, false).phi;
      if (after <= phi + 1e-4 * t * dot(direction, gradient)) {
        phi = after;
        knots = trial;
        step = direction;
        for (double& x : step) x *= t;
        before_gradient = gradient;
        break;
      }
    }
    if (step.empty()) memory.forget();
    // Rounding alone may raise the first sums against the fit's own.
    const double fall = history.back() - phi;
    history.push_back(std::min(phi, history.back()));
    small = fall < options.fall * history.back() ? small + 1 : 0;
    if (small >= 2) break;
  }
  return history;
}

void remove_least_knots(FitProblem& problem, InteriorKnots& knots, int interior_u, int interior_v,
                        const std::function<bool()>& holds, const std::function<bool()>& stop) {
  while (!(stop && stop())) {
    double least = std::numeric_limits<double>::infinity();
    InteriorKnots best;
    for (bool along_v : {false, true}) {
      const auto& line = along_v ? knots.v : knots.u;
      if (static_cast<int>(line.size()) <= (along_v ? interior_v : interior_u)) continue;
      for (std::size_t i = 0; i < line.size(); ++i) {
        InteriorKnots without = knots;
        auto& rest = along_v ? without.v : without.u;
        rest.erase(rest.begin() + static_cast<Index>(i));
        if (problem.solve(without) && problem.phi() < least) {
          least = problem.phi();
          best = without;
        }
      }
    }
    if (!std::isfinite(least) || !problem.solve(best) || !holds()) break;
    knots = std::move(best);
  }
  problem.solve(knots);
}

/// Full-LSPIA with decremental knots [Lan24]: control points by progressive iteration, knots by L-BFGS on the
/// analytic gradient, in turn; then knots removed. Steps from its abstract, for integral splines (no weights); ours:
///  1. a quarter more knots than wanted, at least one, by averaging;
///  2. rounds of 12 LSPIA steps on the control points and one line search on the knots, in their log-spacings so
///     that they stay apart; the error falls each round;
///  3. the knot of least loss removed, to the counts wanted (to a tolerance: prune_knots);
///  4. rounds again.
Placement place_full_lspia(PlacementContext& context, int interior_u, int interior_v) {
  FitProblem& problem = context.problem();
  FullLspiaOptions options;
  options.stop = [&] { return context.stop_requested(); };
  const auto more = [](int n, Index most) {
    return n == 0 ? 0 : static_cast<int>(std::min<Index>(n + std::max(1, n / 4), std::max<Index>(n, most)));
  };
  const int u = more(interior_u, problem.most_functions_u() - problem.degree_u() - 1);
  const int v = more(interior_v, problem.most_functions_v() - problem.degree_v() - 1);
  InteriorKnots knots = place_averaging(context, u, v).knots;
  full_lspia(problem, knots, options);
  remove_least_knots(
      problem, knots, interior_u, interior_v, [] { return true; }, options.stop);
  full_lspia(problem, knots, options);
  settle_knots(knots, interior_u, interior_v);
  Placement placement;
  placement.knots = std::move(knots);
  placement.status = context.stop_requested() ? PlacementStatus::stopped : PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
