#include "data/sample.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/counting_sort.h"
#include "base/narrow.h"
#include "base/uniform_cell.h"
#include "data/thinned.h"
namespace knotfit {
namespace {

constexpr double kEach = 2;         // points a cell and as many again, on average, in proportion
constexpr double kFull = 0.9;       // of the sample: where cells are empty, the grid is made finer up to this
constexpr Index kMostCells = 2048;  // a direction

/// A number that looks random, of an index: the finaliser of SplitMix64 [Steele14].
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// Points sorted by the cells of a uniform grid.
struct Cells {
  std::vector<std::int32_t> order;
  std::vector<Index> start;

  Cells(const ParameterizedPoints& points, Index side) {
    std::vector<std::int32_t> cell(points.size());
    for (Index k = 0; k < points.size(); ++k)
      cell[k] =
          static_cast<std::int32_t>(uniform_cell(points.u(k), side) * side + uniform_cell(points.v(k), side));
    start = counting_sort(cell, side * side, order);
  }
  Index size() const { return static_cast<Index>(start.size()) - 1; }
  Index count(Index cell) const { return start[cell + 1] - start[cell]; }
};

/// Points to draw from a cell that holds `count` of `all`.
Index quota(Index count, Index all, Index most) {
  const double share = static_cast<double>(most) / 2 * static_cast<double>(count) / static_cast<double>(all);
  return std::min(count, static_cast<Index>(std::lround(kEach + share)));
}

Index drawn(const Cells& cells, Index all, Index most) {
  Index sum = 0;
  for (Index c = 0; c < cells.size(); ++c)
    if (cells.count(c) > 0) sum += quota(cells.count(c), all, most);
  return sum;
}

}  // namespace

ParameterizedPoints stratified_sample(const ParameterizedPoints& points, Index most) {
  const Index all = points.size();
  if (all <= most) return points;
  narrow(all);
  Index side = std::max<Index>(1, static_cast<Index>(std::sqrt(static_cast<double>(most) / (2 * kEach))));
  Cells cells(points, side);
  while (side < kMostCells &&
         static_cast<double>(drawn(cells, all, most)) < kFull * static_cast<double>(most)) {
    side = std::min(kMostCells, side * 3 / 2 + 1);
    Cells finer(points, side);
    if (drawn(finer, all, most) > most) break;
    cells = std::move(finer);
  }

  std::vector<Index> taken;
  std::vector<double> weights;
  for (Index c = 0; c < cells.size(); ++c) {
    if (cells.count(c) == 0) continue;
    const auto begin = cells.order.begin() + cells.start[c], end = cells.order.begin() + cells.start[c + 1];
    const auto enough = begin + quota(cells.count(c), all, most);
    std::nth_element(begin, enough, end, [](std::int32_t a, std::int32_t b) {
      return scrambled(static_cast<std::uint64_t>(a)) < scrambled(static_cast<std::uint64_t>(b));
    });
    std::sort(begin, enough);
    double whole = 0, part = 0;
    for (auto k = begin; k < end; ++k) (k < enough ? part : whole) += points.weight(*k);
    whole += part;
    for (auto k = begin; k < enough; ++k) {
      taken.push_back(*k);
      weights.push_back(points.weight(*k) * whole / part);
    }
  }
  // The weights so far add up to those of all points.
  const double share = static_cast<double>(taken.size()) / static_cast<double>(all);
  for (double& w : weights) w *= share;
  ParameterizedPoints sample = picked(points, taken);
  sample.weights = std::move(weights);
  return sample;
}

}  // namespace knotfit
