#include "search/placed_sizes.h"

#include <algorithm>
namespace knotfit {
namespace {

constexpr double kWalkOperations = 6e10;   // some 10 s of one core
constexpr double kRoundOperations = 3e10;  // of one size: large nets get fewer rounds of the error model

}  // namespace

PlacedSizes::PlacedSizes(FitProblem& problem, const SearchedPoints& searched, PlacementContext& context,
                         PlacementContext& on_all, Attempts& attempts, std::string_view method)
    : problem_(problem),
      searched_(searched),
      context_(context),
      on_all_(on_all),
      attempts_(attempts),
      place_(find_method(method)) {
  policy_.operations = kWalkOperations;
}

const SizeOutcome& PlacedSizes::solve(const Spans& spans, const Spans*) {
  if (const SizeOutcome* outcome = seen(spans)) return *outcome;
  const Index nu = spans.first + problem_.degree_u(), nv = spans.second + problem_.degree_v();
  PlacementContext& context = searched_.enough_for(nu * nv) ? context_ : on_all_;
  context.options().rounds =
      static_cast<int>(std::clamp(kRoundOperations / context.problem().operations(nu, nv), 2.0, 12.0));
  const Placement placement = place_(context, spans.first - 1, spans.second - 1);
  SizeOutcome& outcome = outcomes_[spans];
  outcome.error = attempts_.fit(problem_, placement.knots);
  outcome.least_squares_error = problem_.measured(attempts_.tolerance());
  outcome.rms = problem_.rms();
  outcome.holds = attempts_.holds(outcome.error);
  outcome.tries = 1;
  attempts_.list(nu, nv, outcome.error);
  return outcome;
}

}  // namespace knotfit
