#include <algorithm>

#include "place/context.h"
#include "place/shares.h"
namespace knotfit {
namespace {

std::vector<double> quantiles(const ParameterizedPoints& points, int axis, int count) {
  std::vector<double> t(points.size());
  for (Index k = 0; k < points.size(); ++k) t[k] = points.uv[2 * k + axis];
  std::sort(t.begin(), t.end());
  std::vector<double> knots(count);
  for (int i = 0; i < count; ++i) {
    const double at = (i + 1.0) / (count + 1.0) * static_cast<double>(t.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const double next = t[std::min(below + 1, t.size() - 1)];
    knots[i] = t[below] + (at - static_cast<double>(below)) * (next - t[below]);
  }
  // Many points may share a parameter: their knots would coincide.
  widen_spans(knots, 0.01);
  return knots;
}

}  // namespace

/// Knots that leave the same number of points in every strip, the folklore for scattered data; steps ours:
///  1. the parameters of one direction sorted, t_0 <= ... <= t_N, copies kept;
///  2. knot i = 1..k at the quantile i/(k + 1), linear between t_j and t_{j+1} at i N/(k + 1) = j + a;
///  3. no span below 1 % of the mean: copies of a parameter would draw several knots to one place.
Placement place_quantile(PlacementContext& context, int interior_u, int interior_v) {
  const ParameterizedPoints& points = context.problem().points();
  return {.knots = {quantiles(points, 0, interior_u), quantiles(points, 1, interior_v)},
          .status = PlacementStatus::converged};
}

}  // namespace knotfit
