// The size search with knots that minimise the error [METHOD 4.2], where that can pay [METHOD 4.5].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/deadline.h"
#include "fit/error_measure.h"
#include "place/sample_size.h"
#include "search/better_of.h"
#include "search/optimized_sizes.h"
#include "search/routes.h"
#include "search/searched_points.h"
#include "search/size_search.h"
#include "search/worth.h"
namespace knotfit {
namespace {

constexpr long kFits[] = {2000, 12000, 80000};        // fast, balanced, best
constexpr double kOperations[] = {1e11, 5e11, 4e12};  // operations a search may take
constexpr double kLeastSaving = 0.1;                  // below it, optimising is not worth its time
constexpr double kLeastThoroughSaving =
    0.2;  // what a second, thorough look must see after a first that saw little
constexpr double kFewOperations = 2e10;   // seconds: then even a small saving is worth it
constexpr double kManyOperations = 2e10;  // of the last sizes alone: half a minute
constexpr Index kPlacedLeast = 400;       // control points that a last search with placed knots may go to
constexpr double kInsertionReach = 3;     // tolerances from which inserted lines may still come to it
constexpr Index kLeastSampled = 8;        // points of a sample a control point
constexpr double kFitsToOptimise = 2000;  // of the last sizes, for the estimate of the operations

/// Searches with knots of the error model, and says why. Where they hold the tolerance at no size, inserts knot lines where the
/// errors are.
RefineResult search_placed_instead(FitProblem& data, const RefineOptions& options, const Control& control,
                                   const std::string& reason) {
  RefineOptions placed = options;
  placed.method = "error-model";
  const Deadline deadline(control);
  RefineResult result = search_placed(data, placed, control);
  result.method = placed.method;
  result.notes.push_back(reason + "; the knots come from the error model");
  const bool failed = !result.holds && result.error <= kInsertionReach * options.tolerance.value;
  if (!(failed || result.status == Status::reached) || !can_optimise_insertion(data.points())) return result;
  if (options.max_fits > 0) return result;  // the caller's budget is for one search
  if (deadline.over()) return result;
  RefineOptions inserting = options;
  if (result.holds)  // insertion begins too large and drops knots in the end
    inserting.max_control_points =
        std::min<Index>(options.max_control_points > 0 ? options.max_control_points : data.points().size(),
                        result.surface.control_point_count() * 5 / 4);
  RefineResult inserted = insert_isolines(data, inserting, deadline.left(after(result, control)));
  inserted.method = options.method;
  inserted.notes.push_back(
      reason +
      (result.holds
           ? "; knot lines inserted where the errors are need fewer than the error model's knots"
           : "; the error model's knots held the tolerance at no size, and knot lines were inserted"));
  return better_of(std::move(result), std::move(inserted));
}

/// Where no size on a sample held the tolerance: the search on all points.
RefineResult search_all_points(FitProblem& data, const RefineOptions& options, RefineResult sampled,
                               const Attempts& attempts) {
  RefineOptions all = options;
  all.engine = Engine::points;
  if (options.max_fits > 0) all.max_fits = std::max(1L, options.max_fits - sampled.fits);  // for both
  RefineResult result = search_optimal(data, all, after(sampled, attempts.time_left()));
  result.notes.push_back(fmt::format(
      "no size held the tolerance on a sample of {} points; all of them were searched then", sampled.sample));
  if (!result.holds) sampled.status = result.status;  // what the sample could not is no matter then
  return better_of(std::move(sampled), std::move(result));
}

/// Whether seven tenths of the knots in each direction hold the tolerance at the data alone.
bool guard_costs_much(const FitProblem& data, const RefineOptions& options, const RefineResult& guarded) {
  const auto thinned = [](const std::vector<double>& knots) {
    std::vector<double> fewer;
    for (std::size_t i = 0; i < knots.size(); ++i)
      if (i * 7 / 10 != (i + 1) * 7 / 10) fewer.push_back(knots[i]);
    return fewer;
  };
  FitProblem plain(data.points(), options.degree_u, options.degree_v, search_fits(options));
  return plain.solve({thinned(guarded.knots.u), thinned(guarded.knots.v)}) &&
         plain.measured(options.tolerance) <= options.tolerance.value;
}

}  // namespace

RefineResult search_optimal(FitProblem& data, const RefineOptions& options, const Control& control) {
  const int effort = static_cast<int>(options.effort);
  const LeastSquaresOptions fit = search_fits(options);
  Attempts attempts(data, options, control, kFits[effort]);
  attempts.set_stage("features");
  const auto sampled_for = [&](double control_points) {
    return sample_size(data.points().size(), control_points, options.engine);
  };
  SearchedPoints probe(data, options, sampled_for(0));
  if (probe.sampled()) attempts.count(probe.problem());
  PlacementContext plain(probe.problem(), placement_options(options), control);
  const FineModel fine = plain.fine_model();
  KnotWorth worth;
  double operations = 0;
  bool little = false;  // too little is saved
  for (bool thorough : {false, true}) {
    worth = estimate_worth(probe.problem(), fine, options.tolerance, thorough);
    // No search goes beyond half of the points.
    const double points = static_cast<double>(data.points().size());
    const double side = std::sqrt(std::min(worth.control_points, 0.5 * points));
    const Index sample = sampled_for(side * side);
    operations = kFitsToOptimise *
                 ((sample > 0 ? static_cast<double>(sample) : points) * data.points().dimension * 190 +
                  9 * side * side * side * side);
    little = worth.saving < (thorough ? kLeastThoroughSaving : kLeastSaving) && operations > kFewOperations &&
             options.effort != Effort::best;
    if (!little && operations <= kOperations[effort]) break;
  }
  if (little)
    return search_placed_instead(
        data, options, control,
        fmt::format("optimised knots would save about {:.0f} % of the control points", 100 * worth.saving));
  if (operations > kOperations[effort])
    return search_placed_instead(
        data, options, control,
        fmt::format(
            "about {:.2g} control points are too many to optimise their knots at this effort (they would "
            "save about {:.0f} % against uniform ones)",
            worth.control_points, 100 * worth.saving));

  std::optional<SearchedPoints> more;
  if (sampled_for(worth.control_points) != probe.asked())
    more.emplace(data, options, sampled_for(worth.control_points));
  const SearchedPoints& searched = more ? *more : probe;
  const ParameterizedPoints& points = searched.points();
  std::optional<WholeData> whole;
  if (searched.sampled()) {
    attempts.measure_over(&whole.emplace(data, options.tolerance));
    attempts.limit_control_points(points.size() / kLeastSampled);
  }
  std::optional<JoinedPoints> joined;
  if (options.guard || whole) joined.emplace(points);
  std::optional<Guard> guard;
  if (options.guard && !attempts.stopped()) {
    attempts.set_stage("reference");
    guard.emplace(*joined, options.tolerance.value, row_of(options.tolerance.measure).guard_looseness,
                  fine.knots, [&] { return attempts.stopped(); });
  }
  MovingFit problem(joined ? joined->points() : points, options.degree_u, options.degree_v, fit);
  problem.count_first(points.size());
  attempts.count(problem);
  PlacementContext context(problem, placement_options(options), control);
  context.set_fine_model(fine);
  OptimizedSizes solver(problem, context, joined ? &*joined : nullptr, guard ? &*guard : nullptr,
                        whole ? &*whole : nullptr, attempts, options);
  NoisePlateau plateau(options.noise, points.size(), data.points().dimension);
  // Begin with inserted knot lines at effort best, and where growing to the tolerance would cost more. (At balanced effort this
  // saves a third on the ridge and costs as much on peaks.)
  std::optional<Spans> first;
  std::optional<RefineResult> inserted;
  const bool from_inserted =
      options.effort == Effort::best || (options.effort == Effort::balanced && operations > kManyOperations);
  if (from_inserted && can_optimise_insertion(data.points()) && !attempts.stopped()) {
    RefineOptions quick = options;
    if (quick.max_fits == 0) quick.max_fits = kFits[0];
    inserted = insert_isolines(data, quick, attempts.time_left());
    if (inserted->status == Status::reached) first = solver.seed(inserted->knots);
  }
  const Status unmet = search_sizes(data, fine, solver, attempts, plateau, first);
  RefineResult result = attempts.finish(unmet);
  result.metric = fine.knots;
  if (guard || whole) result.least_squares = false;  // not of the data alone
  if (whole) result.sample = points.size();
  if (guard) result.fill_points = guard->fill_count();
  if (whole && !result.holds && result.status != Status::tolerance_below_noise && !attempts.stopped())
    return search_all_points(data, options, std::move(result), attempts);
  bool placed_tried = false;  // by the search without the guard
  const bool near = result.error <= kInsertionReach * options.tolerance.value;
  // Where the data is sparse, its local reference may be wrong, and the points that joined by it are in the way.
  if (guard && options.max_fits == 0 && can_optimise_insertion(points) && !attempts.stopped() &&
      (result.holds ? guard_costs_much(data, options, result) : near)) {
    RefineOptions free = options;
    free.guard = false;
    if (result.holds) free.max_control_points = result.surface.control_point_count();
    RefineResult unguarded = search_optimal(data, free, after(result, attempts.time_left()));
    if (unguarded.holds) {
      unguarded.notes.push_back(
          "where points stand so sparsely that nothing certain can be said between them, the energy alone "
          "holds the surface");
      return better_of(std::move(result), std::move(unguarded));
    }
    placed_tried = !result.holds;
  }
  // Try insertion where the search found nothing, or only found a size past others that swing.
  if (!inserted && (result.holds ? attempts.any_refused() : near) && options.max_fits == 0 &&
      can_optimise_insertion(data.points()) && !attempts.stopped()) {
    RefineOptions fewer = options;
    if (result.holds) fewer.max_control_points = result.surface.control_point_count();
    inserted = insert_isolines(data, fewer, after(result, attempts.time_left()));
  }
  if (inserted) {
    inserted->method = options.method;
    result = better_of(std::move(result), std::move(*inserted));
  }
  // Try placed knots: they begin without the energy, which is too stiff where sparse data lies inside dense data.
  if (result.holds || placed_tried || options.max_fits > 0 || !can_optimise_insertion(data.points()) ||
      attempts.stopped())
    return result;
  RefineOptions placed = options;
  placed.method = "error-model";
  const Index most = std::max(kPlacedLeast, 2 * result.surface.control_point_count());
  placed.max_control_points =
      options.max_control_points > 0 ? std::min(options.max_control_points, most) : most;
  const Status unplaced = result.status;
  RefineResult other = search_placed(data, placed, after(result, attempts.time_left()));
  other.method = placed.method;
  if (other.holds)
    other.notes.push_back(
        "optimised knots found no surface that keeps to the data; the knots come from the error model");
  const bool holds = other.holds;
  result = better_of(std::move(result), std::move(other));
  if (!holds && result.status != Status::stopped && result.status != Status::time_limit)
    result.status = unplaced;
  return result;
}

}  // namespace knotfit
