#include <algorithm>

#include "place/context.h"
#include "place/row_knots.h"
#include "place/shares.h"
namespace knotfit {
namespace {

std::vector<double> averaging(const ParameterizedPoints& points, int axis, int count) {
  std::vector<double> t(points.size());
  for (Index k = 0; k < points.size(); ++k) t[k] = points.uv[2 * k + axis];
  std::sort(t.begin(), t.end());
  // Copies of a parameter would draw several knots to one place.
  t.erase(std::unique(t.begin(), t.end()), t.end());
  const double d = static_cast<double>(t.size()) / static_cast<double>(count + 1);
  std::vector<double> knots(count);
  for (int j = 1; j <= count; ++j) {
    const double jd = j * d;
    const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(jd), 1, t.size() - 1);
    const double a = std::clamp(jd - static_cast<double>(i), 0.0, 1.0);
    knots[j - 1] = (1 - a) * t[i - 1] + a * t[i];
  }
  return knots;
}

}  // namespace

/// [Piegl97 (9.68), (9.69)] on the sorted distinct parameters t_0 < ... < t_N of one direction, n + 1 control points:
/// d = (N + 1)/(n - m + 1), i = int(j d), a = j d - i, u_{m+j} = (1 - a) t_{i-1} + a t_i, j = 1..n-m. Every span then
/// holds a parameter.
Placement place_averaging(PlacementContext& context, int interior_u, int interior_v) {
  const ParameterizedPoints& points = context.problem().points();
  Placement placement;
  placement.knots = {averaging(points, 0, interior_u), averaging(points, 1, interior_v)};
  settle_knots(placement.knots, interior_u, interior_v);
  placement.status = PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
