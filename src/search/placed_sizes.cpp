#include <algorithm>
#include <chrono>
#include <map>

#include "search/size_solver.h"
namespace knotfit {
namespace {

class PlacedSizes final : public SizeSolver {
 public:
  PlacedSizes(FitProblem& problem, PlacementContext& context, Attempts& attempts,
              const RefineOptions& options)
      : problem_(problem), context_(context), attempts_(attempts), place_(find_method(options.method)) {
    policy_.work = 6e10;  // some 10 s of one core
  }

  const SizeOutcome& solve(const Spans& spans, const Spans*) override {
    if (auto it = seen_.find(spans); it != seen_.end()) return it->second;
    const Index nu = spans.first + problem_.degree_u(), nv = spans.second + problem_.degree_v();
    // Large nets get fewer rounds of the error model: a fit there costs more than a round gains.
    context_.options().rounds = static_cast<int>(std::clamp(3e10 / problem_.work(nu, nv), 2.0, 12.0));
    const Placement placement = place_(context_, spans.first - 1, spans.second - 1);
    SizeOutcome& outcome = seen_[spans];
    outcome.error = attempts_.fit(problem_, placement.knots);
    outcome.least_squares_error = problem_.measured(attempts_.tolerance());
    outcome.rms = problem_.rms();
    outcome.holds = attempts_.holds(outcome.error);
    outcome.tries = 1;
    attempts_.list(nu, nv, outcome.error);
    return outcome;
  }

  const SizeOutcome* seen(const Spans& spans) const override {
    const auto it = seen_.find(spans);
    return it == seen_.end() ? nullptr : &it->second;
  }

  bool hopeless(const Spans& c) const override {
    return std::any_of(seen_.begin(), seen_.end(), [&](const auto& s) {
      return s.first.first >= c.first && s.first.second >= c.second &&
             s.second.error > policy_.hopeless * attempts_.tolerance().value;
    });
  }

  const WalkPolicy& policy() const override { return policy_; }

 private:
  FitProblem& problem_;
  PlacementContext& context_;
  Attempts& attempts_;
  PlaceFunction place_;
  WalkPolicy policy_;
  std::map<Spans, SizeOutcome> seen_;
};

}  // namespace

PlacementOptions placement_options(const RefineOptions& o) {
  PlacementOptions placement;
  placement.degree_u = o.degree_u;
  placement.degree_v = o.degree_v;
  placement.smoothing = o.smoothing;
  placement.feature = o.feature;
  placement.user_features = o.user_features;
  placement.evaluations = o.evaluations;
  placement.energy = o.energy;
  placement.keep_by = o.tolerance;
  return placement;
}

std::unique_ptr<SizeSolver> placed_sizes(FitProblem& problem, PlacementContext& context, Attempts& attempts,
                                         const RefineOptions& options) {
  return std::make_unique<PlacedSizes>(problem, context, attempts, options);
}

namespace {

RefineResult search_with(FitProblem& data, const RefineOptions& options, const Control& control) {
  Attempts attempts(data, options, control, 3000);
  PlacementContext context(data, placement_options(options), control);
  NoisePlateau plateau(options.noise, data.points().size(), data.points().dimension);
  attempts.set_stage("features");
  const FineModel& fine = context.fine_model();
  const auto solver = placed_sizes(data, context, attempts, options);
  const Status unmet = search_sizes(data, fine, *solver, attempts, plateau);
  RefineResult result = attempts.finish(unmet);
  result.metric = fine.knots;
  result.notes.insert(result.notes.end(), context.notes().begin(), context.notes().end());
  return result;
}

}  // namespace

// Knots that a method places do not seek places that no point sees, and plain least squares come nearer to the points: the data
// energy joins where a net swings.
RefineResult search_placed(FitProblem& data, const RefineOptions& options, const Control& control) {
  const auto start = std::chrono::steady_clock::now();
  RefineOptions plain = options;
  plain.energy = nullptr;
  LeastSquaresOptions fit = search_fits(plain);
  fit.use_grid = true;
  FitProblem free(data.points(), options.degree_u, options.degree_v, fit);
  RefineResult result = search_with(free, plain, control);
  const bool begun_anew = result.status == Status::swings || result.status == Status::not_reached;
  if (!result.swings && !begun_anew) return result;
  if (control.stop.stop_requested() || out_of_time(control, start)) return result;
  RefineResult held = search_with(data, options, time_left(after(result, control), start));
  if (result.status == Status::not_reached)
    result.status = held.status;  // it was broken off, and says nothing
  return better_of(std::move(held), std::move(result));
}

}  // namespace knotfit
