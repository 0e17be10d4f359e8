#include <algorithm>
#include <cmath>

#include "place/context.h"
#include "place/row_knots.h"
#include "place/shares.h"
namespace knotfit {
namespace {

/// Knots of one direction: the rows are one curve in the space of all their components.
std::vector<double> derivative_share(const RowGrid& grid, bool along_v, int degree, int count) {
  const std::vector<double>& t = grid.lines(along_v);
  const int order = degree + 1;
  const Index lines = static_cast<Index>(t.size()), rows = static_cast<Index>(grid.lines(!along_v).size());
  if (lines <= order + 1) return uniform_knots(count);
  // Divided differences of order p, row by row; one value for t_i .. t_{i+p}.
  const Index width = rows * grid.dimension;
  std::vector<double> d(lines * width);
  for (Index i = 0; i < lines; ++i)
    for (Index j = 0; j < rows; ++j)
      std::copy_n(grid.at(along_v, i, j), grid.dimension, d.begin() + i * width + j * grid.dimension);
  for (int r = 1; r <= order; ++r)
    for (Index i = 0; i + r < lines; ++i)
      for (Index c = 0; c < width; ++c)
        d[i * width + c] = (d[(i + 1) * width + c] - d[i * width + c]) / (t[i + r] - t[i]);
  const Index count_f = lines - order;
  std::vector<double> f(count_f), at(count_f);
  for (Index i = 0; i < count_f; ++i) {
    double square = 0;
    for (Index c = 0; c < width; ++c) square += d[i * width + c] * d[i * width + c];
    f[i] = std::pow(square / static_cast<double>(rows), 0.5 / order);
    for (int r = 0; r <= order; ++r) at[i] += t[i + r] / (order + 1);
  }
  for (int pass = 0; pass < 2; ++pass) {
    const std::vector<double> raw = f;
    for (Index i = 0; i < count_f; ++i)
      f[i] = (raw[std::max<Index>(0, i - 1)] + 2 * raw[i] + raw[std::min(count_f - 1, i + 1)]) / 4;
  }
  // Each value holds between the middles to its neighbours, the outer ones to the ends.
  std::vector<double> breaks{0.0}, mass;
  for (Index i = 0; i < count_f; ++i) {
    const double end = i + 1 < count_f ? (at[i] + at[i + 1]) / 2 : 1.0;
    mass.push_back(f[i] * (end - breaks.back()));
    breaks.push_back(end);
  }
  if (!(*std::max_element(mass.begin(), mass.end()) > 0)) return uniform_knots(count);
  return equal_shares(breaks, mass, count);
}

}  // namespace

/// Knots in equal shares of the p-th root of the p-th derivative, p = m + 1 the order [Yeh20; the idea is that of
/// deBoor01 XII]. The paper was not at hand; from its abstract: derivatives of the data, a feature function of them,
/// smoothed, its cumulative integral cut into equal parts. Ours: divided differences over the lines of the rows, the
/// norm over all rows, two passes of [1 2 1]/4, both directions apart.
Placement place_derivative_share(PlacementContext& context, int interior_u, int interior_v) {
  const RowGrid& grid = context.row_grid();
  Placement placement;
  placement.knots = {derivative_share(grid, false, context.problem().degree_u(), interior_u),
                     derivative_share(grid, true, context.problem().degree_v(), interior_v)};
  settle_knots(placement.knots, interior_u, interior_v);
  placement.status = PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
