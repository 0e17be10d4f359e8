#include "verify/cell_places.h"

#include <algorithm>
namespace knotfit::verify {
namespace {

constexpr Index kFewPoints = 3;

struct Cell {
  Index points;
  double area;
  std::array<double, 2> middle;
};

Index span_of(const std::vector<double>& breaks, double x) {
  const auto last = static_cast<Index>(breaks.size()) - 2;
  return std::clamp<Index>(std::upper_bound(breaks.begin(), breaks.end(), x) - breaks.begin() - 1, 0, last);
}

}  // namespace

std::vector<std::array<double, 2>> cell_places(const Surface& surface, const ParameterizedPoints& points,
                                               Index count) {
  const std::vector<double> u = surface.knots_u().breaks(), v = surface.knots_v().breaks();
  const Index columns = static_cast<Index>(v.size()) - 1;
  std::vector<Index> held((u.size() - 1) * (v.size() - 1), 0);
  for (Index k = 0; k < points.size(); ++k)
    ++held[span_of(u, points.u(k)) * columns + span_of(v, points.v(k))];
  std::vector<Cell> cells;
  for (std::size_t i = 0; i + 1 < u.size(); ++i)
    for (std::size_t j = 0; j + 1 < v.size(); ++j)
      if (const Index n = held[static_cast<Index>(i) * columns + static_cast<Index>(j)]; n < kFewPoints)
        cells.push_back(
            {n, (u[i + 1] - u[i]) * (v[j + 1] - v[j]), {(u[i] + u[i + 1]) / 2, (v[j] + v[j + 1]) / 2}});
  std::stable_sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return a.points != b.points ? a.points < b.points : a.area < b.area;
  });
  cells.resize(std::min(cells.size(), static_cast<std::size_t>(std::max<Index>(0, count))));
  std::vector<std::array<double, 2>> places;
  places.reserve(cells.size());
  for (const Cell& cell : cells) places.push_back(cell.middle);
  return places;
}

}  // namespace knotfit::verify
