#include "search/size_search.h"

#include <algorithm>
#include <array>
#include <cmath>
namespace knotfit {
namespace {

class SizeSearch {
 public:
  SizeSearch(FitProblem& data, const FineModel& fine, SizeSolver& solver, Attempts& attempts,
             NoisePlateau& plateau)
      : data_(data),
        solver_(solver),
        attempts_(attempts),
        plateau_(plateau),
        m_(data.degree_u()),
        n_(data.degree_v()),
        ratio_(attempts.span_ratio() > 0 ? std::clamp(attempts.span_ratio(), 0.2, 5.0) : span_ratio(fine)) {}

  Status run(std::optional<Spans> first) {
    if (first && allowed(*first)) attempts_.set_stage("size search");
    const bool held = first && allowed(*first) && solver_.solve(*first, nullptr).holds;
    const Status unmet = held ? Status::reached : grow();
    if (attempts_.reached() && !attempts_.interrupted()) walk_down();
    return unmet;
  }

 private:
  /// p : q from I_u^{2m+3} / p^{2m+2} = I_v^{2n+3} / q^{2n+2}, with the lower degree for both exponents.
  double span_ratio(const FineModel& fine) const {
    const double m = std::min(m_, n_);
    if (!(fine.integral_u > 0) || !(fine.integral_v > 0))
      return fine.integral_u > 0 ? 5 : fine.integral_v > 0 ? 0.2 : 1;
    return std::clamp(std::pow(fine.integral_u / fine.integral_v, (2 * m + 3) / (2 * m + 2)), 0.2, 5.0);
  }

  Index size(const Spans& s) const { return (s.first + m_) * Index{s.second + n_}; }
  bool allowed(const Spans& s) const {
    return s.first >= 1 && s.second >= 1 && attempts_.allowed(s.first + m_, s.second + n_);
  }

  /// Spans of geometric mean s, within what the grid lines of either direction allow.
  Spans spans(double s) const {
    auto clamp = [](double x, Index most) {
      return static_cast<int>(std::clamp<Index>(std::lround(x), 1, std::max<Index>(1, most)));
    };
    return {clamp(s * std::sqrt(ratio_), data_.most_functions_u() - m_),
            clamp(s / std::sqrt(ratio_), data_.most_functions_v() - n_)};
  }

  /// From small to the first size that holds. \return the status where none does
  Status grow() {
    attempts_.set_stage("size search");
    double s = 4, failed = 0;
    Spans last{};
    for (;;) {
      // One size is always solved, so that there is a best one to return.
      if (failed > 0 && attempts_.interrupted()) return attempts_.interruption();
      Spans now = spans(s);
      bool ends = now == spans(1e9);  // all that the grid lines can tell apart
      if (!allowed(now)) {            // the largest size below the limit ends it
        double low = failed, high = s;
        for (int i = 0; i < 40; ++i) {
          const double middle = (low + high) / 2;
          (allowed(spans(std::max(middle, 1e-3))) ? low : high) = middle;
        }
        s = std::max(low, 1e-3);
        now = spans(s);
        ends = true;
        if (!allowed(now)) break;
      }
      const bool fresh = !solver_.seen(now);
      const SizeOutcome& outcome = solver_.solve(now, failed > 0 ? &last : nullptr);
      if (outcome.holds) {
        narrow_down(failed, s);
        return Status::reached;
      }
      if (ends) break;
      if (fresh && plateau_.add(size(now), outcome.rms)) return Status::tolerance_below_noise;
      last = now;
      failed = s;
      const double order = std::min(m_, n_) + 1;
      const double error =
          std::min(outcome.error, outcome.least_squares_error / solver_.policy().minimax_gain);
      s *= std::clamp(std::pow(error / attempts_.tolerance().value, 1 / order), 1.08, 1.5);
      if (!std::isfinite(s)) s = failed * 1.5;
    }
    return attempts_.own_limit() ? Status::limit_reached : Status::data_too_sparse;
  }

  /// Between the last size that failed and the one that holds.
  void narrow_down(double failed, double holds) {
    if (failed == 0) failed = 0.5;  // the first size held: even one span may
    while (holds > 1.12 * failed && !attempts_.interrupted()) {
      const double middle = std::sqrt(failed * holds);
      const Spans from = spans(holds);
      if (spans(middle) == from) break;
      (solver_.solve(spans(middle), &from).holds ? holds : failed) = middle;
    }
  }

  /// Every smaller neighbour in turn; to the first that holds, and again from there.
  void walk_down() {
    attempts_.set_stage("walk down");
    double operations = 0;
    for (bool moved = true; moved;) {
      moved = false;
      const Spans best{static_cast<int>(attempts_.best().u.size()) + 1,
                       static_cast<int>(attempts_.best().v.size()) + 1};
      for (const Spans& candidate : candidates(best)) {
        if (attempts_.interrupted() ||
            (solver_.policy().operations > 0 && operations > solver_.policy().operations))
          return;
        const long before = attempts_.fits();
        const bool holds = solver_.solve(candidate, &best).holds;
        operations += static_cast<double>(attempts_.fits() - before) *
                      data_.operations(candidate.first + m_, candidate.second + n_);
        if (!holds) continue;
        moved = true;
        break;
      }
    }
  }

  /// Untried nets first, of these the ones 1 or 2 steps away, of these the largest.
  std::vector<Spans> candidates(const Spans& best) const {
    const WalkPolicy& policy = solver_.policy();
    std::vector<std::pair<std::array<Index, 4>, Spans>> list;
    for (int dp = -policy.reach; dp <= policy.reach; ++dp)
      for (int dq = -policy.reach; dq <= policy.reach; ++dq) {
        const Spans c{best.first + dp, best.second + dq};
        if (!allowed(c) || size(c) >= size(best)) continue;
        if (static_cast<double>(size(c)) < policy.least_share * static_cast<double>(size(best))) continue;
        const SizeOutcome* seen = solver_.seen(c);
        if (seen && (seen->tries > 1 || !(seen->error <= policy.retry_within * attempts_.tolerance().value)))
          continue;
        if (solver_.hopeless(c, attempts_.tolerance().value)) continue;
        list.push_back({{seen != nullptr, std::abs(dp) + std::abs(dq) > 2, -size(c), dp}, c});
      }
    std::sort(list.begin(), list.end());
    std::vector<Spans> result;
    result.reserve(list.size());
    for (const auto& entry : list) result.push_back(entry.second);
    return result;
  }

  FitProblem& data_;
  SizeSolver& solver_;
  Attempts& attempts_;
  NoisePlateau& plateau_;
  int m_, n_;
  double ratio_;
};

}  // namespace

Status search_sizes(FitProblem& data, const FineModel& fine, SizeSolver& solver, Attempts& attempts,
                    NoisePlateau& plateau, std::optional<Spans> first) {
  return SizeSearch(data, fine, solver, attempts, plateau).run(first);
}

}  // namespace knotfit
