#include "search/mesh_knots.h"

#include <algorithm>

#include "fit/fit_problem.h"
#include "knotfit/evaluate.h"
#include "place/error_model.h"
#include "place/shares.h"
#include "spline/projection.h"
namespace knotfit {
namespace {

std::vector<double> spread(const KnotVector& knots, int interior) {
  const std::vector<double> breaks = knots.breaks();
  const auto spans = static_cast<double>(breaks.size() - 1);
  std::vector<double> result;
  for (int k = 1; k <= interior; ++k) {
    const double at = spans * k / (interior + 1);
    const auto i = std::min(static_cast<std::size_t>(at), breaks.size() - 2);
    result.push_back(breaks[i] + (at - static_cast<double>(i)) * (breaks[i + 1] - breaks[i]));
  }
  return result;
}

/// As many places in every span as determine the surface, and the ends.
std::vector<double> places(const KnotVector& knots) {
  const std::vector<double> breaks = knots.breaks();
  const int per_span = knots.degree() + 1;
  std::vector<double> x{0};
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    for (int k = 0; k < per_span; ++k)
      x.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * (k + 0.5) / per_span);
  x.push_back(1);
  return x;
}

}  // namespace

Surface carried_over(const Surface& s, const KnotVector& u, const KnotVector& v) {
  Surface result = s;
  if (!(s.knots_u() == u)) result = project_u(result, u).surface;
  if (!(s.knots_v() == v)) result = transposed(project_u(transposed(result), v).surface);
  return result;
}

InteriorKnots knots_anew(const Surface& s, int interior_u, int interior_v) {
  const std::vector<double> u = places(s.knots_u()), v = places(s.knots_v());
  ParameterizedPoints grid;
  grid.dimension = s.dimension();
  grid.values = evaluate_grid(s, u, v);
  for (const double a : u)
    for (const double b : v) grid.uv.insert(grid.uv.end(), {a, b});
  LeastSquaresOptions options;
  options.estimate_condition = false;
  FitProblem problem(grid, s.degree_u(), s.degree_v(), options);
  problem.solve({s.knots_u().interior(), s.knots_v().interior()});
  InteriorKnots knots = knots_of_density(problem, interior_u, interior_v);
  const auto halfway = [](std::vector<double>& x, const std::vector<double>& from) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = (x[i] + from[i]) / 2;
    widen_spans(x, kLeastMeshSpan);
  };
  halfway(knots.u, spread(s.knots_u(), interior_u));
  halfway(knots.v, spread(s.knots_v(), interior_v));
  return knots;
}

}  // namespace knotfit
