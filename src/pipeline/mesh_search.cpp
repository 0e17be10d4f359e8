#include "pipeline/mesh_search.h"

#include <algorithm>
#include <cmath>

#include "pipeline/mesh_knots.h"
#include "pipeline/mesh_rounds.h"
#include "place/shares.h"
namespace knotfit {
namespace {

using correction::Rounds;
using Spans = std::pair<int, int>;

constexpr double kGrow = 1.4, kStep = 1.05;  // of the product of the spans, coarse and fine
constexpr double kNear = 2;                  // times the tolerance: what the last rounds may gain
constexpr int kKnotSteps = 4;
constexpr long kMostRounds = 6000;
constexpr Index kMostControlPoints = 5000;  // by default: the system's factor grows with the square
constexpr double kBeyond = 3;  // a size that holds but folds is passed by sizes up to this many times larger

class MeshSizes {
 public:
  MeshSizes(const correction::CorrectionWork& work, const FitOptions& options, const Tolerance& tolerance,
            const Control& control)
      : work_(work),
        options_(options),
        tolerance_(tolerance),
        control_(control),
        stage_(control, "size search"),
        ways_(options.method == "uniform"       ? 0
              : options.method == "error-model" ? 1
                                                : 2),
        ratio_(std::clamp(options.span_ratio > 0 ? options.span_ratio : work.options().aspect, 0.2, 5.0)),
        most_(options.max_control_points > 0 ? options.max_control_points
                                             : std::min(work.data() / 2, kMostControlPoints)),
        most_rounds_(options.max_fits > 0 ? options.max_fits : kMostRounds),
        rounds_of_(work, options.degree_u, options.degree_v, tolerance, control, true),
        rounds_(std::max(1, work.options().rounds * 2 / 5)) {}

  MeshSearch run() {
    grow();
    if (status_ == Status::reached && work_.options().fairness > 0 && !interrupted()) make_fair();
    MeshSearch found;
    found.correction = verified_ ? std::move(*verified_) : work_.finish(best_.rounds, false, control_);
    found.status = control_.stop.stop_requested() ? Status::stopped
                   : stage_.over()                ? Status::time_limit
                                                  : status_;
    found.tried = std::move(tried_);
    found.fits = rounds_of_.fits();
    found.method = ways_ == 0 ? "uniform" : ways_ == 1 ? "error-model" : "optimal";
    return found;
  }

 private:
  struct State {
    Spans spans{};
    Rounds rounds;
  };

  enum class Outcome { misses, folds, holds };

  Index size(const Spans& s) const {
    return (s.first + Index{options_.degree_u}) * (s.second + Index{options_.degree_v});
  }
  Spans spans(double product) const {
    const auto whole = [](double x) { return std::max(1, static_cast<int>(std::lround(x))); };
    return {whole(std::sqrt(product * ratio_)), whole(std::sqrt(product / ratio_))};
  }
  static InteriorKnots uniform(const Spans& s) {
    return {uniform_knots(s.first - 1), uniform_knots(s.second - 1)};
  }
  bool interrupted() const { return stage_.over() || rounds_of_.fits() >= most_rounds_; }

  /// On uniform knots; the same for every tolerance. \param from  a smaller size; null: from the map
  State solve(const Spans& at, const State* from) {
    if (!from || !from->rounds.surface)
      return {at, rounds_of_.correct(work_.first(), uniform(at), nullptr, rounds_)};
    return {at, rounds_of_.correct(from->rounds.uv, uniform(at), &*from->rounds.surface, rounds_)};
  }

  bool near(const Rounds& r) const {
    return r.surface && r.error <= kNear * tolerance_.value && !interrupted();
  }
  Rounds polished(Rounds base) const {
    return near(base) ? rounds_of_.polished(std::move(base)) : std::move(base);
  }

  /// Measured on the whole surface. One that only folds is kept until a larger one does not.
  Outcome verify(State& state) {
    if (!rounds_of_.meets(state.rounds)) return Outcome::misses;
    CorrectionResult result = work_.finish(state.rounds, false, control_);
    const double error = work_.error(result, tolerance_);
    state.rounds.error = std::min(state.rounds.error, error);
    if (error > tolerance_.value) return Outcome::misses;
    const bool holds = !folds_over(result.folds);
    if (holds || !verified_) verified_ = std::move(result);
    if (holds) held_ = state.rounds;
    if (!holds && folded_ == 0) folded_ = size(state.spans);
    return holds ? Outcome::holds : Outcome::folds;
  }

  /// What a size may still gain, where the tolerance is near: first on its knots, then on others as far as the method
  /// moves them. \return true where it holds, verified
  bool settle(const State& state) {
    State last{state.spans, polished(state.rounds)};
    Rounds moved = state.rounds;
    for (int way = 0; way < ways_ && !rounds_of_.meets(last.rounds) && near(state.rounds); ++way) {
      moved = way == 0 ? rounds_of_.with_knots_anew(moved, rounds_)
                       : rounds_of_.with_knots_moved(moved, kKnotSteps);
      Rounds polish = polished(moved);
      if (polish.merit() < last.rounds.merit()) last.rounds = std::move(polish);
    }
    Outcome outcome = verify(last);
    if (outcome == Outcome::folds && !interrupted()) {
      // The folds may have come with the parameters of smaller sizes.
      State anew{state.spans, polished(rounds_of_.correct(work_.first(), uniform(state.spans), nullptr,
                                                          work_.options().rounds))};
      outcome = verify(anew);
      if (outcome == Outcome::holds) last = std::move(anew);
    }
    const bool holds = outcome == Outcome::holds;
    if (!best_.rounds.surface || last.rounds.merit() < best_.rounds.merit()) best_ = last;
    tried_.push_back({state.spans.first + options_.degree_u, state.spans.second + options_.degree_v,
                      last.rounds.error * work_.frame().diagonal, holds});
    if (control_.progress)
      control_.progress({.stage = "size search",
                         .error = best_.rounds.error * work_.frame().diagonal,
                         .tolerance = tolerance_.value * work_.frame().diagonal,
                         .size_u = tried_.back().size_u,
                         .size_v = tried_.back().size_v,
                         .fits = rounds_of_.fits()});
    return holds;
  }

  /// From small to the first size that holds.
  void grow() {
    std::optional<State> last;
    for (double product = 4;; product *= kGrow) {
      const Spans at = spans(product);
      if (last && at == last->spans) continue;
      if (size(at) > most_ && last) {
        status_ = options_.max_control_points > 0 || most_ == kMostControlPoints ? Status::limit_reached
                                                                                 : Status::data_too_sparse;
        break;
      }
      if (last && interrupted()) {
        status_ = Status::limit_reached;
        break;
      }
      if (folded_ > 0 && static_cast<double>(size(at)) > kBeyond * static_cast<double>(folded_)) break;
      State now = solve(at, last ? &*last : nullptr);
      if (settle(now)) {
        status_ = Status::reached;
        if (last) refine(*last, product / kGrow, product);
        return;
      }
      last = std::move(now);
    }
    if (folded_ > 0) status_ = Status::folded;
  }

  /// Between a size that failed and one that holds.
  void refine(State last, double low, double high) {
    const Index held = size(spans(high));
    for (double product = low * kStep; product < high && !interrupted(); product *= kStep) {
      const Spans at = spans(product);
      if (at == last.spans || size(at) >= held) continue;
      State now = solve(at, &last);
      if (settle(now)) return;
      last = std::move(now);
    }
  }

  /// The smallest that holds once more with the fairness charged, taken where it still holds and its normals are nearer
  /// the mesh's. The search is blind to it: on nets that are too coarse for the mesh it would only lead astray.
  void make_fair() {
    Rounds fair = rounds_of_.faired(held_);
    if (!rounds_of_.meets(fair)) return;
    CorrectionResult result = work_.finish(std::move(fair), false, control_);
    if (work_.error(result, tolerance_) <= tolerance_.value && !folds_over(result.folds) &&
        result.folds.normal_angle < verified_->folds.normal_angle)
      verified_ = std::move(result);
  }

  const correction::CorrectionWork& work_;
  const FitOptions& options_;
  Tolerance tolerance_;
  const Control& control_;
  Stage stage_;
  int ways_;  ///< to move the knots
  double ratio_;
  Index most_;
  long most_rounds_;
  MeshRounds rounds_of_;
  int rounds_;
  Status status_ = Status::not_run;
  State best_;
  Rounds held_;  ///< of the size that holds
  std::optional<CorrectionResult> verified_;
  Index folded_ = 0;  ///< the first size that holds the tolerance and folds
  std::vector<SizeTried> tried_;
};

}  // namespace

MeshSearch fit_mesh_size(const correction::CorrectionWork& work, const FitOptions& options,
                         const Tolerance& tolerance, const Control& control) {
  constexpr int kAnew = 2, kSteps = 12;
  const MeshRounds rounds(work, options.degree_u, options.degree_v, tolerance, control, false);
  const int all = work.options().rounds;
  const InteriorKnots uniform{uniform_knots(options.control_points_u - options.degree_u - 1),
                              uniform_knots(options.control_points_v - options.degree_v - 1)};
  // Moved knots may gain distance by a fold: the last stage that does not fold counts, else the one that does least.
  std::vector<Rounds> stages{rounds.correct(work.first(), uniform, nullptr, all)};
  const auto add = [&](Rounds next) {
    if (next.rounds.size() > stages.back().rounds.size()) stages.push_back(std::move(next));
  };
  if (options.method == "error-model" || options.method == "optimal") {
    Rounds best = stages.back();
    for (int k = 0; k < kAnew; ++k) best = rounds.with_knots_anew(std::move(best), (all + 1) / 2);
    add(std::move(best));
  }
  if (options.method == "optimal") add(rounds.with_knots_moved(stages.back(), kSteps));
  MeshSearch found;
  for (std::size_t k = stages.size(); k-- > 0;) {
    const bool first = k + 1 == stages.size();
    if (options.tolerance) stages[k] = rounds.polished(std::move(stages[k]));
    CorrectionResult result = work.finish(stages[k], false, control);
    if (first || result.folds.blurred < found.correction.folds.blurred) found.correction = std::move(result);
    if (!folds_over(found.correction.folds) || control.stop.stop_requested()) break;
  }
  found.status = control.stop.stop_requested() ? Status::stopped : Status::fixed_size;
  found.fits = rounds.fits();
  found.method = options.method;
  return found;
}

MeshSearch search_mesh_sizes(const correction::CorrectionWork& work, const FitOptions& options,
                             const Tolerance& tolerance, const Control& control) {
  return MeshSizes(work, options, tolerance, control).run();
}

}  // namespace knotfit
