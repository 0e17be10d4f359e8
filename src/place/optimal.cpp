// Knots that minimise the fitting error itself [METHOD 3.5].
#include <algorithm>
#include <limits>

#include "place/context.h"
#include "place/relocate.h"
#include "place/shares.h"
namespace knotfit {

namespace {

constexpr double kExact = 1e-20;  // of sum w |P|^2: the data is met to rounding
constexpr double kSame = 1e-6;    // starts that reached the same phi are one minimum

double squared_values(const ParameterizedPoints& points) {
  double sum = 0;
  for (Index k = 0; k < points.size(); ++k)
    for (int d = 0; d < points.dimension; ++d)
      sum += points.weight(k) * points.value(k)[d] * points.value(k)[d];
  return sum;
}

}  // namespace

/// Knots that minimise phi(U,V), the least-squares error with the control points eliminated: variable projection
/// [Golub73] with Kaufman's Jacobian [Kaufman75], in logarithms of the spacings [Jupp78], by Levenberg-Marquardt with
/// Nielsen's damping [Nielsen99]. Steps [METHOD 3.5]; the starts, 2 and 3 are ours:
///  1. from three starts (two-stage error model, the error model iterated at the counts from uniform, equal marginal
///     shares of the feature measure) to a local minimum each;
///  2. from each, relocation: the knot of least loss dropped, one inserted where the gain is greatest, minimised again;
///  3. ties: near pairs of knots become one of higher multiplicity where phi falls;
///  4. the least phi of all, relocated once more: four knots, each tried at three peaks of the gain.
Placement place_optimal(PlacementContext& context, int interior_u, int interior_v) {
  MovingFit& problem = context.moving();
  std::vector<InteriorKnots> starts;
  context.options().rounds = 4;
  context.options().keep_by = {0, ErrorMeasure::rms};
  starts.push_back(place_error_model(context, interior_u, interior_v).knots);
  starts.push_back(equal_share(context.features(), interior_u, interior_v));
  starts.push_back(error_model_from(context, {uniform_knots(interior_u), uniform_knots(interior_v)}, 12));

  LevenbergOptions levenberg;
  levenberg.stop = [&] { return context.stop_requested(); };
  struct Optimum {
    InteriorKnots knots;
    double phi;
  };
  std::vector<Optimum> optima;
  for (InteriorKnots& start : starts) {
    widen_spans(start.u, 0.01);
    widen_spans(start.v, 0.01);
    const double phi = minimize_over_knots(problem, start, levenberg);
    optima.push_back({start, phi});
  }
  std::stable_sort(optima.begin(), optima.end(), [](auto& a, auto& b) { return a.phi < b.phi; });
  // Relocation leads elsewhere from each, and the start of least error is not always the one that ends lowest.
  const double exact = kExact * squared_values(problem.points());
  double phi = std::numeric_limits<double>::infinity(), before = -1;
  Placement placement;
  placement.knots = optima.front().knots;
  for (Optimum& optimum : optima) {
    if (phi <= exact || context.stop_requested()) break;
    if (optimum.phi <= before * (1 + kSame)) continue;
    before = optimum.phi;
    optimum.phi = relocate_knots(problem, optimum.knots, optimum.phi, levenberg);
    optimum.phi = tie_knots(problem, optimum.knots, optimum.phi, levenberg);
    if (optimum.phi < phi) {
      phi = optimum.phi;
      placement.knots = optimum.knots;
    }
  }
  if (phi > exact && !context.stop_requested())
    relocate_knots(problem, placement.knots, phi, levenberg, {.candidates = 4, .peaks = 3});
  problem.solve(placement.knots);
  placement.status = context.stop_requested() ? PlacementStatus::stopped : PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
