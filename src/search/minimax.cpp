#include "search/minimax.h"

#include <algorithm>
#include <cmath>

#include "base/clones.h"
#include "base/parallel.h"
#include "place/damped_step.h"
#include "place/levenberg.h"
namespace knotfit {
namespace {

constexpr double kSquares = 1e-3;  // share of plain squares in Phi: beat 1e-2 and 1e-4 [METHOD 4.3]

constexpr int kBlock = 64;  // points whose powers are taken at once

/// result_i = q_i^(power/2) for squares q >= 0 and a whole power: products and at most one root. Spoils q.
KNOTFIT_CLONES void half_powers(double* q, int power, double* result) {
  for (int i = 0; i < kBlock; ++i) result[i] = power % 2 ? std::sqrt(q[i]) : 1.0;
  for (int n = power / 2; n > 0; n /= 2) {
    if (n % 2)
      for (int i = 0; i < kBlock; ++i) result[i] *= q[i];
    for (int i = 0; i < kBlock; ++i) q[i] *= q[i];
  }
}

/// Phi = sum (q/g)^P / P + eps omega q^2 / 2 with q = |r| / scale, at fixed P and scale.
class Phi {
 public:
  Phi(MovingFit& problem, const PointShares& shares, int power, double scale)
      : problem_(problem), shares_(shares), power_(power), scale_(scale) {}

  /// At residual + t (other - residual).
  double value(const std::vector<double>& residual, const std::vector<double>& other, double t) const {
    const int d = problem_.points().dimension;
    const double inverse = 1 / (scale_ * scale_);
    return parallel_sum<double>(static_cast<Index>(residual.size()) / d, [&](Index begin, Index end) {
      double sum = 0, q[kBlock] = {}, scaled[kBlock] = {}, powers[kBlock];
      for (Index first = begin; first < end; first += kBlock) {
        const int count = static_cast<int>(std::min<Index>(kBlock, end - first));
        for (int k = 0; k < count; ++k) {
          const Index i = first + k;
          double square = 0;
          for (int e = 0; e < d; ++e) {
            const double r = residual[i * d + e] + t * (other[i * d + e] - residual[i * d + e]);
            square += r * r;
          }
          q[k] = square * inverse;
          scaled[k] = q[k] * slack2(i);
        }
        half_powers(scaled, power_, powers);
        for (int k = 0; k < count; ++k) sum += powers[k] / power_ + kSquares * base(first + k) * q[k] / 2;
      }
      return sum;
    });
  }

  /// The weights whose squares have Phi's gradient at the residual.
  std::vector<double> weights(const std::vector<double>& residual) const {
    const int d = problem_.points().dimension;
    const double inverse = 1 / (scale_ * scale_);
    std::vector<double> w(residual.size() / d);
    parallel_chunks(static_cast<Index>(w.size()), [&](Index, Index begin, Index end) {
      double q[kBlock] = {}, powers[kBlock];
      for (Index first = begin; first < end; first += kBlock) {
        const int count = static_cast<int>(std::min<Index>(kBlock, end - first));
        for (int k = 0; k < count; ++k) {
          const Index i = first + k;
          double square = 0;
          for (int e = 0; e < d; ++e) square += residual[i * d + e] * residual[i * d + e];
          q[k] = square * inverse * slack2(i);
        }
        half_powers(q, power_ - 2, powers);
        for (int k = 0; k < count; ++k)
          w[first + k] = powers[k] * slack2(first + k) + kSquares * base(first + k);
      }
    });
    return w;
  }

 private:
  double base(Index i) const { return shares_.base.empty() ? 1.0 : shares_.base[i]; }
  double slack2(Index i) const {
    return shares_.inverse_slack.empty() ? 1.0 : shares_.inverse_slack[i] * shares_.inverse_slack[i];
  }
  MovingFit& problem_;
  const PointShares& shares_;
  int power_;
  double scale_;
};

double largest(const std::vector<double>& residual, const PointShares& shares, int d) {
  struct Largest {
    double square = 0;
    Largest& operator+=(const Largest& o) {
      square = std::max(square, o.square);
      return *this;
    }
  };
  const Index n = static_cast<Index>(residual.size()) / d;
  return std::sqrt(parallel_sum<Largest>(n, [&](Index begin, Index end) {
                     Largest most;
                     for (Index i = begin; i < end; ++i) {
                       double q = 0;
                       for (int e = 0; e < d; ++e) q += residual[i * d + e] * residual[i * d + e];
                       if (!shares.inverse_slack.empty())
                         q *= shares.inverse_slack[i] * shares.inverse_slack[i];
                       most.square = std::max(most.square, q);
                     }
                     return most;
                   }).square);
}

void step_towards(std::vector<double>& from, const std::vector<double>& to, double t) {
  parallel_chunks(static_cast<Index>(from.size()), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) from[i] += t * (to[i] - from[i]);
  });
}

/// One P: Newton steps of the control points by weighted fits, steps of the knots around them.
class Stage {
 public:
  Stage(MovingFit& problem, const PointShares& shares, const MinimaxOptions& options, int power, double scale)
      : problem_(problem),
        shares_(shares),
        options_(options),
        power_(power),
        scale_(scale),
        phi_(problem, shares, power, scale) {}

  /// Runs from the state; calls keep(state) for every state accepted. \return false where a fit failed
  template <class Keep>
  bool run(NetState& state, const Keep& keep) {
    weights_ = phi_.weights(state.residual);
    if (!inner(state, 2 * options_.inner_rounds, 1e-4)) return false;
    keep(state);
    if (!options_.move_knots || (state.knots.u.empty() && state.knots.v.empty())) return true;
    Damping damping;
    for (int step = 0; step < options_.outer_steps; ++step) {
      if (state.max <= options_.enough || (options_.stop && options_.stop())) break;
      // The factor of the present weights, with the L_P state's own residual.
      problem_.set_weights(weights_);
      if (!problem_.factor(state.knots)) return false;
      problem_.restore(state.net, state.residual);
      SpacingStep model(problem_, state.knots, false, (power_ - 1) / (scale_ * scale_),
                        1 / (scale_ * scale_));
      const double before = value_;
      const std::vector<double> weights = weights_;
      bool accepted = false;
      for (int refused = 0; refused < 6; ++refused) {
        if (!model.solve(damping.mu, 0.5)) {
          damping.mu *= 4;
          continue;
        }
        NetState trial;
        trial.knots = model.moved(options_.least_span);
        weights_ = weights;
        if (inner(trial, options_.inner_rounds, 1e-3) && value_ < before) {
          state = std::move(trial);
          accepted = true;
          damping = {.mu = std::max(0.2 * damping.mu, 1e-9)};
          keep(state);
          break;
        }
        damping.refuse();
      }
      if (!accepted) {
        weights_ = weights;
        value_ = before;
        break;
      }
      if (before - value_ < 2e-3 * before) break;
    }
    return true;
  }

 private:
  /// c <- c + t (c_w - c) at fixed knots, from the fit of the weights at hand. Residuals are linear in t, so
  /// a trial costs one pass and no fit; Newton's own t is 1/(P-1).
  bool inner(NetState& state, int rounds, double fall) {
    problem_.set_weights(weights_);
    if (!problem_.solve(state.knots)) return false;
    state.net = problem_.net();
    state.residual = problem_.residual();
    value_ = phi_.value(state.residual, state.residual, 0);
    double first_t = 1;  // of the line search: a step above the last that won
    for (int round = 0; round < rounds; ++round) {
      weights_ = phi_.weights(state.residual);
      problem_.set_weights(weights_);
      if (!problem_.solve(state.knots)) return false;
      const std::vector<double>& other = problem_.residual();
      double best = value_, best_t = 0;
      for (double t = first_t; t > 0.3 / (power_ - 1); t *= 0.6) {
        const double m = phi_.value(state.residual, other, t);
        if (m < best) {
          best = m;
          best_t = t;
        } else if (best_t > 0) {
          break;
        }
      }
      if (best_t == 0) break;
      first_t = std::min(1.0, best_t / 0.6);
      step_towards(state.residual, other, best_t);
      step_towards(state.net, problem_.net(), best_t);
      const double before = value_;
      value_ = best;
      if (before - best < fall * before) break;
    }
    weights_ = phi_.weights(state.residual);
    state.max = largest(state.residual, shares_, problem_.points().dimension);
    return std::isfinite(state.max);
  }

  MovingFit& problem_;
  const PointShares& shares_;
  const MinimaxOptions& options_;
  int power_;
  double scale_;
  Phi phi_;
  std::vector<double> weights_;
  double value_ = 0;
};

/// Stages beyond this power lower the maximum by at most this factor: seen in 100 runs on the synthetic sets.
double later_gain(double power) {
  return power < 9 ? 1.8 : power < 13 ? 1.35 : power < 20 ? 1.2 : power < 30 ? 1.1 : power < 45 ? 1.05 : 1.02;
}

}  // namespace

double largest_error(MovingFit& problem, const PointShares& shares) {
  return largest(problem.residual(), shares, problem.points().dimension);
}

NetState state_of(MovingFit& problem, const PointShares& shares) {
  return {problem.knots(), problem.net(), problem.residual(), largest_error(problem, shares)};
}

NetState minimize_maximum(MovingFit& problem, const PointShares& shares, const MinimaxOptions& options) {
  NetState state = state_of(problem, shares), best = state;
  auto keep = [&](const NetState& s) {
    if (s.max < best.max) best = s;
  };
  int stale = 0;
  for (double power : options.powers) {
    if (best.max <= options.enough || !(state.max > 0) || (options.stop && options.stop())) break;
    const double before = best.max;
    Stage stage(problem, shares, options, static_cast<int>(power), state.max);
    if (!stage.run(state, keep)) break;
    if (options.patience > 0 && best.max > options.patience * later_gain(power) * options.enough) break;
    stale = best.max < before ? 0 : stale + 1;
    if (stale == 2) break;
  }
  problem.set_weights(shares.base);
  problem.factor(best.knots);
  problem.restore(best.net, best.residual);
  return best;
}

std::vector<double> minimax_weights(MovingFit& problem, const PointShares& shares, double power) {
  const double scale = largest_error(problem, shares);
  return Phi(problem, shares, static_cast<int>(power), scale > 0 ? scale : 1).weights(problem.residual());
}

}  // namespace knotfit
