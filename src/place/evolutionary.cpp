#include "place/evolutionary.h"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "knotfit/exceptions.h"
#include "place/context.h"
#include "place/shares.h"
namespace knotfit {
namespace {

struct Search {
  PlacementContext* context;
  int u, v;
  nlopt_opt optimizer;
  InteriorKnots best;
  double least = HUGE_VAL;

  InteriorKnots knots(const double* x) const {
    InteriorKnots k{{x, x + u}, {x + u, x + u + v}};
    widen_spans(k.u, 0.01);
    widen_spans(k.v, 0.01);
    return k;
  }
};

double error_of(unsigned, const double* x, double*, void* data) {
  Search& search = *static_cast<Search*>(data);
  if (search.context->stop_requested()) {
    nlopt_force_stop(search.optimizer);
    return HUGE_VAL;
  }
  const InteriorKnots knots = search.knots(x);
  FitProblem& problem = search.context->problem();
  const double phi = problem.solve(knots) ? problem.phi() : 1e300;
  if (phi < search.least) {
    search.least = phi;
    search.best = knots;
  }
  return phi;
}

Placement evolve(PlacementContext& context, int interior_u, int interior_v, nlopt_algorithm algorithm) {
  const int unknowns = interior_u + interior_v;
  Placement placement;
  placement.knots = {uniform_knots(interior_u), uniform_knots(interior_v)};
  placement.status = PlacementStatus::limit;
  const long evaluations = context.options().evaluations;
  if (unknowns == 0 || evaluations < 1) return placement;
  const auto destroy = [](nlopt_opt o) { nlopt_destroy(o); };
  const std::unique_ptr<nlopt_opt_s, decltype(destroy)> optimizer(
      nlopt_create(algorithm, static_cast<unsigned>(unknowns)), destroy);
  Search search{&context, interior_u, interior_v, optimizer.get(), placement.knots, HUGE_VAL};
  nlopt_srand(1);  // the same search every time
  nlopt_set_lower_bounds1(optimizer.get(), 0);
  nlopt_set_upper_bounds1(optimizer.get(), 1);
  nlopt_set_min_objective(optimizer.get(), error_of, &search);
  nlopt_set_maxeval(optimizer.get(), static_cast<int>(std::min<long>(evaluations, 1L << 30)));
  std::vector<double> x(placement.knots.u);
  x.insert(x.end(), placement.knots.v.begin(), placement.knots.v.end());
  double least = 0;
  nlopt_optimize(optimizer.get(), x.data(), &least);  // its verdict does not matter: the best seen is kept
  placement.knots = search.best;
  if (context.stop_requested()) placement.status = PlacementStatus::stopped;
  return placement;
}

}  // namespace

/// Global search over the knots by an evolutionary algorithm, the stand-in for genetic, immune, annealing,
/// estimation-of-distribution and swarm methods. Every candidate is a point of [0,1]^(k_u + k_v), its coordinates
/// sorted into knots (no span below 1 % of the mean), and its fitness the least-squares error there; the start is
/// uniform; PlacementOptions::evaluations ends it. ESCH [Santos10] of NLopt, seeded.
Placement place_evolutionary(PlacementContext& context, int interior_u, int interior_v) {
  return evolve(context, interior_u, interior_v, NLOPT_GN_ESCH);
}

/// The same by controlled random search with local mutation [Price83; Kaelo06].
Placement place_evolutionary_crs(PlacementContext& context, int interior_u, int interior_v) {
  return evolve(context, interior_u, interior_v, NLOPT_GN_CRS2_LM);
}

/// The same by an evolution strategy with stochastic ranking [Runarsson05].
Placement place_evolutionary_isres(PlacementContext& context, int interior_u, int interior_v) {
  return evolve(context, interior_u, interior_v, NLOPT_GN_ISRES);
}

}  // namespace knotfit
