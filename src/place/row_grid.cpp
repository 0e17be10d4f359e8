#include "place/row_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/evaluate.h"
#include "place/shares.h"
namespace knotfit {
namespace {

constexpr int kLines = 101;

/// Of heights: the surface (u, v, z) they stand for.
void set_positions(RowGrid& grid, int dimension, const std::vector<double>& values) {
  const std::size_t rows = grid.u.size(), columns = grid.v.size();
  grid.dimension = dimension == 1 ? 3 : dimension;
  if (dimension > 1) {
    grid.x = values;
    return;
  }
  grid.x.reserve(3 * rows * columns);
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j)
      grid.x.insert(grid.x.end(), {grid.u[i], grid.v[j], values[i * columns + j]});
}

}  // namespace

RowGrid make_row_grid(FitProblem& problem, const InteriorKnots& uniform) {
  RowGrid grid;
  const ParameterizedPoints& points = problem.points();
  const int d = points.dimension;
  std::vector<double> values;
  if (GridLayout layout = find_grid(points); !layout.empty()) {
    grid.u = std::move(layout.u);
    grid.v = std::move(layout.v);
    for (Index k : layout.point) values.insert(values.end(), points.value(k), points.value(k) + d);
  } else {
    for (int i = 0; i < kLines; ++i) grid.u.push_back(i / (kLines - 1.0));
    grid.v = grid.u;
    if (problem.solve(uniform))
      values = evaluate_grid(problem.surface(), grid.u, grid.v);
    else  // nothing to see: a flat sheet, where no place is better than another
      values.assign(static_cast<std::size_t>(kLines * kLines * d), 0.0);
    grid.note = fmt::format(
        "the method asks for rows of points: the data was resampled on {} x {} lines of its parameters, from "
        "a fit of {} x {} uniform spans",
        kLines, kLines, uniform.u.size() + 1, uniform.v.size() + 1);
  }
  set_positions(grid, d, values);
  return grid;
}

RowShape row_shape(const RowGrid& grid, bool along_v) {
  const Index lines = static_cast<Index>(grid.lines(along_v).size());
  const Index rows = static_cast<Index>(grid.lines(!along_v).size());
  const int d = grid.dimension;
  RowShape shape{std::vector<double>(lines, 0.0), std::vector<double>(lines, 0.0)};
  for (Index i = 1; i < lines; ++i)
    for (Index j = 0; j < rows; ++j) {
      const double* here = grid.at(along_v, i, j);
      const double* before = grid.at(along_v, i - 1, j);
      double aa = 0;
      for (int e = 0; e < d; ++e) aa += (here[e] - before[e]) * (here[e] - before[e]);
      shape.length[i] += std::sqrt(aa);
      if (i + 1 == lines) continue;
      const double* next = grid.at(along_v, i + 1, j);
      double bb = 0, ab = 0;
      for (int e = 0; e < d; ++e) {
        bb += (next[e] - here[e]) * (next[e] - here[e]);
        ab += (here[e] - before[e]) * (next[e] - here[e]);
      }
      // |a x b| in any dimension.
      shape.bend[i] += std::atan2(std::sqrt(std::max(0.0, aa * bb - ab * ab)), ab);
    }
  return shape;
}

}  // namespace knotfit
