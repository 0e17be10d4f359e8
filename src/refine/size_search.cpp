// Sizes p x q from the error model, knots placed anew at each, then the walk down [METHOD 4].
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "place/context.h"
#include "refine/attempts.h"
namespace knotfit {
namespace {

using Spans = std::pair<int, int>;  ///< p, q

class SizeSearch {
 public:
  SizeSearch(FitProblem& problem, const RefineOptions& options, const Control& control)
      : attempts_(problem, options, control),
        problem_(problem),
        options_(options),
        control_(control),
        place_(find_method(options.method)),
        m_(problem.degree_u()),
        n_(problem.degree_v()),
        context_(problem, placement_options(options), control),
        plateau_(options.noise, problem.points().size(), problem.points().dimension) {}

  RefineResult run() {
    attempts_.set_stage("features");
    const FineModel& fine = context_.fine_model();
    const Status unmet = grow(span_ratio(fine));
    if (attempts_.reached() && !attempts_.interrupted()) walk_down();
    RefineResult result = attempts_.finish(unmet);
    result.metric = fine.knots;
    return result;
  }

 private:
  struct Outcome {
    double error = 0;
    bool holds = false;
  };

  static PlacementOptions placement_options(const RefineOptions& o) {
    PlacementOptions placement;
    placement.degree_u = o.degree_u;
    placement.degree_v = o.degree_v;
    placement.smoothing = o.smoothing;
    placement.feature = o.feature;
    placement.user_features = o.user_features;
    placement.keep_by = o.tolerance;
    return placement;
  }

  /// p : q from I_u^{2m+3} / p^{2m+2} = I_v^{2n+3} / q^{2n+2} at a geometric mean of s; for equal degrees
  /// (I_u / I_v)^{(2m+3)/(2m+2)} whatever s.
  double span_ratio(const FineModel& fine) const {
    const double m = std::min(m_, n_);
    if (!(fine.integral_u > 0) || !(fine.integral_v > 0))
      return fine.integral_u > 0 ? 5 : fine.integral_v > 0 ? 0.2 : 1;
    return std::clamp(std::pow(fine.integral_u / fine.integral_v, (2 * m + 3) / (2 * m + 2)), 0.2, 5.0);
  }

  Index functions_u(const Spans& s) const { return s.first + m_; }
  Index functions_v(const Spans& s) const { return s.second + n_; }
  Index size(const Spans& s) const { return functions_u(s) * functions_v(s); }
  bool allowed(const Spans& s) const {
    return s.first >= 1 && s.second >= 1 && attempts_.allowed(functions_u(s), functions_v(s));
  }

  /// Spans of geometric mean s, within what the grid lines of either direction allow.
  Spans spans(double s, double ratio) const {
    auto clamp = [](double x, Index most) {
      return static_cast<int>(std::clamp<Index>(std::lround(x), 1, std::max<Index>(1, most)));
    };
    return {clamp(s * std::sqrt(ratio), problem_.most_functions_u() - m_),
            clamp(s / std::sqrt(ratio), problem_.most_functions_v() - n_)};
  }

  const Outcome& solve(const Spans& spans) {
    if (auto seen = seen_.find(spans); seen != seen_.end()) return seen->second;
    // Large nets get fewer rounds of the error model: a fit there costs more than a round gains.
    context_.options().rounds =
        static_cast<int>(std::clamp(3e10 / problem_.work(functions_u(spans), functions_v(spans)), 2.0, 12.0));
    Placement placement = place_(context_, spans.first - 1, spans.second - 1);
    Outcome& outcome = seen_[spans];
    outcome.error = attempts_.fit(placement.knots);
    outcome.holds = attempts_.holds(outcome.error);
    attempts_.list(functions_u(spans), functions_v(spans), outcome.error);
    rms_ = problem_.rms();
    return outcome;
  }

  /// From small to the first size that holds. \return the status where none does
  Status grow(double ratio) {
    attempts_.set_stage("size search");
    double s = 4, failed = 0;
    for (;;) {
      if (attempts_.interrupted()) return attempts_.interruption();
      Spans now = spans(s, ratio);
      bool last = false;
      if (!allowed(now)) {  // the largest size below the limit ends it
        double low = failed, high = s;
        for (int i = 0; i < 40; ++i) {
          const double middle = (low + high) / 2;
          (allowed(spans(std::max(middle, 1e-3), ratio)) ? low : high) = middle;
        }
        s = low;
        now = spans(std::max(s, 1e-3), ratio);
        last = true;
        if (!allowed(now)) break;
      }
      const bool seen = seen_.contains(now);
      const Outcome& outcome = solve(now);
      if (outcome.holds) {
        narrow_down(failed, s, ratio);
        return Status::reached;
      }
      if (last) break;
      if (!seen && plateau_.add(size(now), rms_)) return Status::tolerance_below_noise;
      failed = s;
      const double order = std::min(m_, n_) + 1;
      s *= std::clamp(std::pow(outcome.error / attempts_.tolerance().value, 1 / order), 1.08, 1.5);
      if (!std::isfinite(s)) s = failed * 1.5;
    }
    return attempts_.own_limit() ? Status::limit_reached : Status::data_too_sparse;
  }

  /// Between the last size that failed and the one that holds.
  void narrow_down(double failed, double holds, double ratio) {
    if (failed == 0) failed = 0.5;  // the first size held: even one span may
    while (holds > 1.12 * failed && !attempts_.interrupted()) {
      const double middle = std::sqrt(failed * holds);
      if (spans(middle, ratio) == spans(holds, ratio)) break;
      (solve(spans(middle, ratio)).holds ? holds : failed) = middle;
    }
  }

  /// Every smaller neighbour in turn; to the first that holds, and again from there.
  void walk_down() {
    attempts_.set_stage("walk down");
    double work = 0;
    for (bool moved = true; moved;) {
      moved = false;
      Spans best{static_cast<int>(attempts_.best().u.size()) + 1,
                 static_cast<int>(attempts_.best().v.size()) + 1};
      for (const Spans& candidate : candidates(best)) {
        if (attempts_.interrupted() || work > kWalkWork) return;
        const long fits = problem_.fits();
        const bool holds = solve(candidate).holds;
        work += static_cast<double>(problem_.fits() - fits) *
                problem_.work(functions_u(candidate), functions_v(candidate));
        if (!holds) continue;
        moved = true;
        break;
      }
    }
  }

  /// Nets of 80 to 100 % of the control points: those 1 or 2 steps away first, the largest first.
  std::vector<Spans> candidates(const Spans& best) const {
    std::vector<std::pair<std::array<Index, 3>, Spans>> list;
    for (int dp = -4; dp <= 4; ++dp)
      for (int dq = -4; dq <= 4; ++dq) {
        const Spans c{best.first + dp, best.second + dq};
        if (!allowed(c) || size(c) >= size(best) || size(c) * 5 < size(best) * 4 || seen_.contains(c))
          continue;
        if (hopeless(c)) continue;
        list.push_back({{std::abs(dp) + std::abs(dq) > 2, -size(c), dp}, c});
      }
    std::sort(list.begin(), list.end());
    std::vector<Spans> result;
    for (const auto& entry : list) result.push_back(entry.second);
    return result;
  }

  /// A net that contains this one failed by a margin.
  bool hopeless(const Spans& c) const {
    return std::any_of(seen_.begin(), seen_.end(), [&](const auto& s) {
      return s.first.first >= c.first && s.first.second >= c.second &&
             s.second.error > 1.5 * attempts_.tolerance().value;
    });
  }

  static constexpr double kWalkWork = 6e10;  ///< operations of the walk: some 10 s of one core

  Attempts attempts_;
  FitProblem& problem_;
  const RefineOptions& options_;
  const Control& control_;
  PlaceFunction place_;
  int m_, n_;
  PlacementContext context_;
  NoisePlateau plateau_;
  std::map<Spans, Outcome> seen_;
  double rms_ = 0;
};

}  // namespace

RefineResult search_sizes(FitProblem& problem, const RefineOptions& options, const Control& control) {
  return SizeSearch(problem, options, control).run();
}

}  // namespace knotfit
