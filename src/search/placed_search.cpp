// The size search with knots that a method of the table places.
#include "base/deadline.h"
#include "search/better_of.h"
#include "search/placed_sizes.h"
#include "search/routes.h"
#include "search/searched_points.h"
#include "search/size_search.h"
namespace knotfit {
namespace {

constexpr long kMostFits = 3000;

RefineResult search_with(FitProblem& data, const RefineOptions& options, const Control& control) {
  Attempts attempts(data, options, control, kMostFits);
  // Fits of a grid are quick, whatever its number of points.
  const bool sampling = !data.on_grid() && placement_method(options.method).traits.refits;
  SearchedPoints searched(data, options, sampling ? sample_size(data.points().size(), 0, options.engine) : 0);
  PlacementContext context(searched.problem(), placement_options(options), control),
      on_all(data, placement_options(options), control);
  if (searched.sampled()) attempts.count(searched.problem());
  NoisePlateau plateau(options.noise, data.points().size(), data.points().dimension);
  attempts.set_stage("features");
  const FineModel& fine = context.fine_model();
  on_all.set_fine_model(fine);
  PlacedSizes solver(data, searched, context, on_all, attempts, options.method);
  const Status unmet = search_sizes(data, fine, solver, attempts, plateau);
  RefineResult result = attempts.finish(unmet);
  result.metric = fine.knots;
  if (searched.sampled() && searched.enough_for(result.surface.control_point_count()))
    result.sample = searched.points().size();
  for (const PlacementContext* c : {&context, &on_all})
    result.notes.insert(result.notes.end(), c->notes().begin(), c->notes().end());
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
