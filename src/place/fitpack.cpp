#include <algorithm>

#include "place/context.h"
#include "place/row_knots.h"
#include "place/shares.h"
namespace knotfit {
namespace {

/// Squared residuals of the spans of one direction, and their mean place.
struct SpanSums {
  std::vector<double> squares, place;
};

SpanSums span_sums(const ParameterizedPoints& points, const std::vector<double>& errors, int axis,
                   const std::vector<double>& breaks) {
  SpanSums sums{std::vector<double>(breaks.size() - 1, 0.0), std::vector<double>(breaks.size() - 1, 0.0)};
  for (Index k = 0; k < points.size(); ++k) {
    const double t = points.uv[2 * k + axis], square = points.weight(k) * errors[k] * errors[k];
    const auto s = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, t) - breaks.begin() - 1;
    sums.squares[s] += square;
    sums.place[s] += square * t;
  }
  return sums;
}

}  // namespace

/// The greedy rule of surfit [Dierckx93 5.4 and his code fpsurf]: from no interior knots,
///  1. fit;
///  2. of the spans of both directions still short of knots, the one with the largest sum of squared residuals;
///  3. a new knot at the residuals' own mean place in it, sum r^2 t / sum r^2; a place ten times nearer to one end
///     of the span than to the other is passed over for the next span;
///  4. again, one fit a knot.
/// Ours: least squares at each step without his smoothing factor, the counts wanted in place of it; where no span
/// passes the test of step 3, the longest is halved.
Placement place_fitpack(PlacementContext& context, int interior_u, int interior_v) {
  FitProblem& problem = context.problem();
  const ParameterizedPoints& points = problem.points();
  InteriorKnots knots;
  const auto missing = [&](int axis) {
    return static_cast<int>((axis == 0 ? knots.u : knots.v).size()) < (axis == 0 ? interior_u : interior_v);
  };
  while ((missing(0) || missing(1)) && !context.stop_requested()) {
    if (!problem.solve(knots)) break;
    const std::vector<double> errors = problem.errors();
    double largest = 0, place = -1;
    int axis = 0;
    for (int a : {0, 1}) {
      if (!missing(a)) continue;
      const std::vector<double> breaks = with_ends(a == 0 ? knots.u : knots.v);
      const SpanSums sums = span_sums(points, errors, a, breaks);
      for (std::size_t s = 0; s < sums.squares.size(); ++s) {
        if (!(sums.squares[s] > largest)) continue;
        const double at = sums.place[s] / sums.squares[s], before = at - breaks[s],
                     after = breaks[s + 1] - at;
        if (before > 10 * after || after > 10 * before) continue;
        largest = sums.squares[s];
        place = at;
        axis = a;
      }
    }
    if (place < 0) break;
    auto& line = axis == 0 ? knots.u : knots.v;
    line.insert(std::upper_bound(line.begin(), line.end(), place), place);
  }
  Placement placement;
  placement.knots = std::move(knots);
  settle_knots(placement.knots, interior_u, interior_v);
  placement.status = context.stop_requested() ? PlacementStatus::stopped : PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
