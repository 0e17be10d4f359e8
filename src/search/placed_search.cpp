// The size search with knots that a method of the table places.
#include "base/deadline.h"
#include "search/better_of.h"
#include "search/placed_sizes.h"
#include "search/routes.h"
#include "search/searched.h"
#include "search/size_search.h"
namespace knotfit {
namespace {

constexpr long kMostFits = 3000;

RefineResult search_with(FitProblem& data, const RefineOptions& options, const Control& control) {
  Attempts attempts(data, options, control, kMostFits);
  // Fits of a grid are quick, whatever its number of points.
  RefineOptions engine = options;
  if (data.on_grid() || !placement_method(options.method).traits.refits) engine.engine = Engine::points;
  Searched searched(data, engine, 0);
  PlacementContext context(data, placement_options(options), control),
      on_sample(searched.problem(), placement_options(options), control);
  if (searched.sampled()) attempts.count(searched.problem());
  NoisePlateau plateau(options.noise, data.points().size(), data.points().dimension);
  attempts.set_stage("features");
  const FineModel& fine = on_sample.fine_model();
  context.set_fine_model(fine);
  PlacedSizes solver(data, context, searched.sampled() ? &on_sample : nullptr, searched, attempts,
                     options.method);
  const Status unmet = search_sizes(data, fine, solver, attempts, plateau);
  RefineResult result = attempts.finish(unmet);
  result.metric = fine.knots;
  if (searched.sampled() && searched.enough_for(result.surface.control_point_count()))
    result.sample = searched.points().size();
  result.notes.insert(result.notes.end(), context.notes().begin(), context.notes().end());
  return result;
}

}  // namespace

// Placed knots do not seek places that no point sees, and plain least squares come nearer to the points: the data energy
// joins where a net swings.
RefineResult search_placed(FitProblem& data, const RefineOptions& options, const Control& control) {
  const Deadline deadline(control);
  RefineOptions plain = options;
  plain.energy = nullptr;
  LeastSquaresOptions fit = search_fits(plain);
  fit.use_grid = true;
  FitProblem free(data.points(), options.degree_u, options.degree_v, fit);
  RefineResult result = search_with(free, plain, control);
  const bool begun_anew = result.status == Status::swings || result.status == Status::not_reached;
  if ((!result.swings && !begun_anew) || deadline.over()) return result;
  RefineResult held = search_with(data, options, deadline.left(after(result, control)));
  if (result.status == Status::not_reached)
    result.status = held.status;  // it was broken off, and says nothing
  return better_of(std::move(held), std::move(result));
}

}  // namespace knotfit
