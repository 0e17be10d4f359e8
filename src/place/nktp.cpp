#include <algorithm>
#include <cmath>
#include <numeric>

#include "place/context.h"
#include "place/row_knots.h"
#include "place/shares.h"
namespace knotfit {

/// Groups of parameters, one a control point: their means, averaged m at a time, are the knots [Piegl00]. The paper
/// was not at hand; these are the steps as later literature gives them [METHOD 2.3]. Parameters t_0 <= ... <= t_N
/// of one direction (the lines of the rows), k interior knots, n = k + m + 1 control points:
///  1. g_0 = {t_0}, g_{n-1} = {t_N}; with step = (N - 1)/(n - 2), group i = 1..n-2 holds t_a .. t_{b-1},
///     a = 1 + floor((i-1) step), b = max(a + 1, 1 + floor(i step));
///  2. representatives r_i = mean of group i;
///  3. knots u_j = (r_j + ... + r_{j+m-1})/m, j = 1..k.
std::vector<double> nktp_knots(std::span<const double> t, int count, int degree) {
  const Index n = Index{count} + degree + 1, last = static_cast<Index>(t.size()) - 1;
  std::vector<double> r(n);
  r.front() = t.front();
  r.back() = t.back();
  const double step = n > 2 ? static_cast<double>(last - 1) / static_cast<double>(n - 2) : 0;
  for (Index i = 1; i + 1 < n; ++i) {
    // Fewer lines than control points: groups share theirs.
    const Index a = std::min(last, 1 + static_cast<Index>(std::floor(static_cast<double>(i - 1) * step)));
    const Index b =
        std::max(a + 1, std::min(last, 1 + static_cast<Index>(std::floor(static_cast<double>(i) * step))));
    r[i] = std::accumulate(t.begin() + a, t.begin() + b, 0.0) / static_cast<double>(b - a);
  }
  return averaged_knots(r, degree);
}

/// nktp_knots() of the lines of the rows, each direction apart; scattered points are resampled as rows (ours).
Placement place_nktp(PlacementContext& context, int interior_u, int interior_v) {
  const RowGrid& grid = context.row_grid();
  Placement placement;
  placement.knots = {nktp_knots(grid.u, interior_u, context.problem().degree_u()),
                     nktp_knots(grid.v, interior_v, context.problem().degree_v())};
  settle_knots(placement.knots, interior_u, interior_v);
  placement.status = PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
