#include "search/optimized_sizes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "fit/error_measure.h"
#include "place/shares.h"
namespace knotfit {
namespace {

// Tolerances: a least-squares optimum whose maximum is farther off is beyond what minimax gains.
constexpr double kMinimaxReach = 3.5;
// Tolerances: nearer than this after minimax, relocate knots in the weights of minimax too.
constexpr double kNear = 1.15;
// Tolerances: farther than this, only the effort "best" tries other optima of the same size.
constexpr double kFar = 1.25;
// Rounds in which places or points join a surface that holds without them.
constexpr int kGuardExchanges = 4, kExchanges = 12;
// Operations of one fit: a net that needs more is not optimised.
constexpr double kMostOperations = 1e9;

Spans spans_of(const InteriorKnots& knots) {
  return {static_cast<int>(knots.u.size()) + 1, static_cast<int>(knots.v.size()) + 1};
}

/// Any knots: for second tries.
InteriorKnots random_knots(int count_u, int count_v, std::mt19937_64& engine) {
  auto line = [&](int count) {
    std::vector<double> knots(count);
    for (double& x : knots) x = static_cast<double>(engine() >> 11) * 0x1p-53;
    widen_spans(knots, 0.2);
    return knots;
  };
  InteriorKnots knots;
  knots.u = line(count_u);
  knots.v = line(count_v);
  return knots;
}

}  // namespace

OptimizedSizes::OptimizedSizes(MovingFit& problem, PlacementContext& context, JoinedPoints* joined,
                               Guard* guard, WholeData* whole, Attempts& attempts,
                               const RefineOptions& options)
    : problem_(problem),
      context_(context),
      joined_(joined),
      guard_(guard),
      whole_(whole),
      attempts_(attempts),
      options_(options),
      to_maximum_(row_of(options.tolerance.measure).every_point) {
  levenberg_.fall = 2e-3;
  levenberg_.stop = [this] { return attempts_.stopped(); };
  context_.options().rounds = 4;
  context_.options().keep_by = {0, ErrorMeasure::rms};
  const bool minimax = to_maximum_ && options.effort != Effort::fast;
  policy_.minimax_gain = minimax ? 1.7 : 1;
  policy_.hopeless = minimax ? 4 : 1.5;
  policy_.hopeless_twice = 1.6;
  if (options.effort == Effort::best) policy_.retry_within = 4;
  if (options.effort == Effort::balanced) {
    policy_.reach = 2;
    policy_.hopeless = minimax ? 1.35 : 1.3;
    policy_.growth = 2;
  }
  use_base_weights();
}

Spans OptimizedSizes::seed(InteriorKnots knots) {
  seed_ = std::move(knots);
  return spans_of(*seed_);
}

void OptimizedSizes::use_base_weights() {
  if (joined_) {
    shares_ = joined_->shares(problem_);
  } else if (!problem_.points().weights.empty()) {
    shares_.base.resize(problem_.points().size());
    for (Index i = 0; i < problem_.points().size(); ++i)
      shares_.base[i] = problem_.points().weights[problem_.order().input(i)];
  }
  problem_.set_weights(shares_.base);
}

double OptimizedSizes::measured() const {
  return to_maximum_ ? largest_error(problem_, shares_)
                     : whole_over_sample_ * problem_.measured(options_.tolerance);
}

std::vector<InteriorKnots> OptimizedSizes::starts(const Spans& spans, const Entry* from, bool strong,
                                                  const Entry& entry) {
  const int ku = spans.first - 1, kv = spans.second - 1;
  std::vector<InteriorKnots> result;
  if (!strong) {
    result.push_back(place_error_model(context_, ku, kv).knots);
  } else {
    result = {entry.knots, equal_share(context_.features(), ku, kv),
              error_model_from(context_, {uniform_knots(ku), uniform_knots(kv)}, 12)};
    std::mt19937_64 engine(static_cast<std::uint64_t>(ku) * 1000 + static_cast<std::uint64_t>(kv));
    for (int i = 0; i < 2; ++i) result.push_back(random_knots(ku, kv, engine));
    for (InteriorKnots& knots : result) {
      widen_spans(knots.u, 0.01);
      widen_spans(knots.v, 0.01);
    }
  }
  if (seed_ && spans_of(*seed_) == spans) result.push_back(*seed_);
  if (from) {
    result.push_back(adapt_knots(problem_, from->knots, ku, kv, levenberg_));
    if (from->outcome.holds && !(from->minimax == InteriorKnots{}) && options_.effort != Effort::fast)
      result.push_back(adapt_knots(problem_, from->minimax, ku, kv, levenberg_));
  }
  return result;
}

const SizeOutcome& OptimizedSizes::solve(const Spans& spans, const Spans* from) {
  Entry& entry = entries_.try_emplace(spans, Entry{outcomes_[spans], {}, {}}).first->second;
  const int most_tries = policy_.retry_within > 0 ? 2 : 1;
  if (entry.outcome.holds || entry.outcome.tries >= most_tries) return entry.outcome;
  const bool strong = entry.outcome.tries++ > 0;
  if (problem_.operations(spans.first + problem_.degree_u(), spans.second + problem_.degree_v()) >
      kMostOperations)
    return place_only(spans, entry);
  const Entry* source = from && entries_.contains(*from) ? &entries_.at(*from) : nullptr;
  use_base_weights();

  std::vector<Start> optima;
  for (InteriorKnots& knots : starts(spans, source, strong, entry)) {
    Start start{std::move(knots)};
    start.phi = minimize_over_knots(problem_, start.knots, levenberg_);
    if (strong) start.phi = relocate_knots(problem_, start.knots, start.phi, levenberg_, {8, 3});
    start.error = measured();
    optima.push_back(std::move(start));
    if (attempts_.stopped()) break;
  }
  std::stable_sort(optima.begin(), optima.end(),
                   [](const Start& a, const Start& b) { return a.phi < b.phi; });
  if (!strong && options_.effort != Effort::fast) {
    Start& best = optima.front();
    best.phi = relocate_knots(problem_, best.knots, best.phi, levenberg_, {4, 2});
    best.error = measured();
  }
  if (optima.front().error < entry.outcome.least_squares_error || entry.knots == InteriorKnots{}) {
    entry.knots = optima.front().knots;
    entry.outcome.least_squares_error = optima.front().error;
  }
  problem_.solve(optima.front().knots);
  entry.outcome.rms = std::min(entry.outcome.rms, problem_.rms());

  for (std::size_t i = 0; i < optima.size() && !entry.outcome.holds; ++i) {
    if (i > 0 && optima[i].phi > 1.5 * optima.front().phi) break;
    if (i > 0 && std::abs(optima[i].phi - optima.front().phi) < 1e-3 * optima.front().phi) continue;
    if (i > 0 && options_.effort != Effort::best && entry.outcome.error > kFar * attempts_.tolerance().value)
      break;
    finish(entry, optima[i]);
    if (attempts_.interrupted()) break;
  }
  attempts_.list(spans.first + problem_.degree_u(), spans.second + problem_.degree_v(), entry.outcome.error);
  use_base_weights();
  return entry.outcome;
}

const SizeOutcome& OptimizedSizes::place_only(const Spans& spans, Entry& entry) {
  use_base_weights();
  context_.options().rounds = 2;
  entry.knots = place_error_model(context_, spans.first - 1, spans.second - 1).knots;
  context_.options().rounds = 4;
  problem_.solve(entry.knots);
  entry.outcome.error = entry.outcome.least_squares_error = measured();
  entry.outcome.rms = problem_.rms();
  entry.outcome.error = attempts_.offer(problem_, entry.outcome.error);
  entry.outcome.holds = attempts_.holds(entry.outcome.error);
  attempts_.list(spans.first + problem_.degree_u(), spans.second + problem_.degree_v(), entry.outcome.error);
  return entry.outcome;
}

void OptimizedSizes::take_new_points() {
  problem_.take_new_points();
  use_base_weights();
}

bool OptimizedSizes::exchange() {
  if (guard_ && guard_->exchange(problem_) > 0) return true;
  if (!whole_) return false;
  const FitProblem& all = whole_->measure(problem_);
  if (to_maximum_) return whole_->join_worst(*joined_) > 0;
  const double sampled = problem_.measured(options_.tolerance);
  if (sampled > 0) whole_over_sample_ = all.measured(options_.tolerance) / sampled;
  return false;
}

void OptimizedSizes::fill(Start& start) {
  const double near = (to_maximum_ ? kMinimaxReach : 1.2) * attempts_.tolerance().value;
  for (int round = 0; round < 3 && guard_ && start.error < near && !attempts_.stopped(); ++round) {
    problem_.solve(start.knots);
    if (guard_->fill(problem_) == 0) return;
    take_new_points();
    start.phi = minimize_over_knots(problem_, start.knots, levenberg_);
    start.error = measured();
  }
}

void OptimizedSizes::finish(Entry& entry, Start& start) {
  const double tolerance = attempts_.tolerance().value;
  use_base_weights();
  fill(start);
  problem_.solve(start.knots);
  double error = measured();
  bool least_squares = true;
  NetState state = state_of(problem_, shares_);
  const bool minimax = to_maximum_ && options_.effort != Effort::fast;
  MinimaxOptions options;
  options.enough = tolerance;
  options.least_span = levenberg_.least_span;
  options.stop = levenberg_.stop;
  options.patience = options_.effort == Effort::best ? 1.1 : 1;
  auto improve = [&] {
    state = minimize_maximum(problem_, shares_, options);
    error = state.max;
    least_squares = false;
  };
  if (minimax && error > tolerance && error < kMinimaxReach * tolerance) {
    improve();
    for (int round = 0; round < 2 && error > tolerance && error < kNear * tolerance; ++round) {
      // Relocate knots in the weighted norm, then minimax again.
      const NetState before = state;
      problem_.set_weights(minimax_weights(problem_, shares_, 9));
      InteriorKnots knots = state.knots;
      problem_.solve(knots);
      relocate_knots(problem_, knots, problem_.phi(), levenberg_, {2, 2});
      state = state_of(problem_, shares_);
      improve();
      if (error < before.max) continue;
      state = before;
      error = before.max;
      break;
    }
  }
  // A surface that holds is checked at all points, and at all places between them where it could be off.
  const int most_rounds = whole_ ? kExchanges : kGuardExchanges;
  for (int round = 0; round < most_rounds && joined_ && error <= tolerance; ++round) {
    problem_.evaluate(state.knots, state.net);
    if (!exchange()) break;
    take_new_points();
    problem_.factor(state.knots);
    problem_.evaluate(state.knots, state.net);
    state.residual = problem_.residual();
    if (to_maximum_) {
      error = state.max = largest_error(problem_, shares_);
      if (error > tolerance && minimax) improve();
    } else {
      InteriorKnots knots = state.knots;
      minimize_over_knots(problem_, knots, levenberg_);
      error = measured();
      state = state_of(problem_, shares_);
    }
  }
  problem_.evaluate(state.knots, state.net);
  if (error < entry.outcome.error) {
    entry.minimax = state.knots;
    error = attempts_.offer(problem_, error, least_squares);
    entry.outcome.error = std::min(entry.outcome.error, error);
    entry.outcome.holds = attempts_.holds(error);
  }
}

}  // namespace knotfit
