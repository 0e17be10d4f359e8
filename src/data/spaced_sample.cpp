#include "data/spaced_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "base/vec3.h"
namespace knotfit {
namespace {

constexpr int kMostBits = 20;       // of a cell's number in one direction
constexpr double kOneSided = 0.25;  // of a cell, from its mean to that of the cells about it: a border

struct CubicGrid {
  std::array<double, 3> low{};
  double cell = 1;

  std::array<std::int64_t, 3> at(const double* p) const {
    std::array<std::int64_t, 3> k;
    for (int c = 0; c < 3; ++c) k[c] = static_cast<std::int64_t>((p[c] - low[c]) / cell);
    return k;
  }
};

/// A cell's number; neighbours of the outermost cells have one too.
std::uint64_t key_of(const std::array<std::int64_t, 3>& at) {
  std::uint64_t key = 0;
  for (int c = 0; c < 3; ++c) key = (key << (kMostBits + 1)) | static_cast<std::uint64_t>(at[c] + 1);
  return key;
}

/// Numbers the keys that were added, in the order of their first coming. Room for a given number of them.
class KeyTable {
 public:
  explicit KeyTable(Index most) : most_(most) {
    std::size_t slots = 16;
    while (slots < 2 * static_cast<std::size_t>(most)) slots *= 2;
    key_.resize(slots);
    number_.assign(slots, -1);
  }
  Index size() const { return size_; }
  /// \return the key's number; -1: there is no room for it
  Index add(std::uint64_t key) {
    const std::size_t s = slot(key);
    if (number_[s] < 0 && size_ < most_) key_[s] = key, number_[s] = size_++;
    return number_[s];
  }
  /// \return -1: it was not added
  Index find(std::uint64_t key) const { return number_[slot(key)]; }

 private:
  std::size_t slot(std::uint64_t key) const {
    const std::size_t last = key_.size() - 1;
    std::size_t s = (key * 0x9e3779b97f4a7c15ULL >> 20) & last;
    while (number_[s] >= 0 && key_[s] != key) s = (s + 1) & last;
    return s;
  }
  Index most_, size_ = 0;
  std::vector<std::uint64_t> key_;
  std::vector<Index> number_;
};

/// Whether the points take at most so many cells.
bool fits(std::span<const double> points, const CubicGrid& grid, Index most) {
  KeyTable table(most);
  for (std::size_t k = 0; k < points.size(); k += 3)
    if (table.add(key_of(grid.at(&points[k]))) < 0) return false;
  return true;
}

CubicGrid finest(std::span<const double> points, Index most) {
  CubicGrid grid;
  grid.low = {INFINITY, INFINITY, INFINITY};
  std::array<double, 3> high{-INFINITY, -INFINITY, -INFINITY};
  for (std::size_t k = 0; k < points.size(); ++k) {
    grid.low[k % 3] = std::min(grid.low[k % 3], points[k]);
    high[k % 3] = std::max(high[k % 3], points[k]);
  }
  double side = 0;
  for (int c = 0; c < 3; ++c) side = std::max(side, high[c] - grid.low[c]);
  if (!(side > 0)) return grid;
  const double room = side * (1 + 1e-9);              // the farthest point lies in the last cell
  Index cells = 1, too_many = Index{1} << kMostBits;  // along the longest side
  while (too_many - cells > std::max<Index>(1, cells / 128)) {
    const Index middle = cells < 64 ? std::min(2 * cells, (cells + too_many) / 2) : (cells + too_many) / 2;
    grid.cell = room / static_cast<double>(middle);
    (fits(points, grid, most) ? cells : too_many) = middle;
  }
  grid.cell = room / static_cast<double>(cells);
  return grid;
}

struct Cell {
  std::array<std::int64_t, 3> at{};
  Vec3 sum{};
  Index count = 0;
  Vec3 mean() const { return (1 / static_cast<double>(count)) * sum; }
};

/// The mean of the cell's and its 26 neighbours' means, each counted once.
Vec3 mean_about(const Cell& cell, const KeyTable& table, const std::vector<Cell>& cells) {
  Vec3 sum{};
  int count = 0;
  std::array<std::int64_t, 3> at;
  for (int k = 0; k < 27; ++k) {
    at = {cell.at[0] + k % 3 - 1, cell.at[1] + k / 3 % 3 - 1, cell.at[2] + k / 9 - 1};
    const Index other = table.find(key_of(at));
    if (other < 0) continue;
    sum += cells[other].mean();
    ++count;
  }
  return (1.0 / count) * sum;
}

}  // namespace

std::vector<Index> spaced_sample(std::span<const double> points, Index most) {
  const auto n = static_cast<Index>(points.size()) / 3;
  std::vector<Index> sample;
  if (n <= most) {
    sample.resize(static_cast<std::size_t>(n));
    std::iota(sample.begin(), sample.end(), Index{0});
    return sample;
  }
  const CubicGrid grid = finest(points, most);
  KeyTable table(most);
  std::vector<Cell> cells;
  std::vector<Index> cell_of(static_cast<std::size_t>(n));
  for (Index k = 0; k < n; ++k) {
    const double* p = &points[3 * k];
    const std::array<std::int64_t, 3> at = grid.at(p);
    const Index c = cell_of[k] = table.add(key_of(at));
    if (c == static_cast<Index>(cells.size())) cells.push_back({.at = at});
    cells[c].sum += Vec3{p[0], p[1], p[2]};
    ++cells[c].count;
  }
  struct Wanted {
    Vec3 from, outwards;
    bool border;
    double best = INFINITY;
    Index point = -1;
  };
  std::vector<Wanted> wanted;
  for (const Cell& cell : cells) {
    const Vec3 mean = cell.mean(), away = mean - mean_about(cell, table, cells);
    wanted.push_back({mean, away, length(away) > kOneSided * grid.cell});
  }
  for (Index k = 0; k < n; ++k) {
    Wanted& w = wanted[cell_of[k]];
    const Vec3 from_mean = Vec3{points[3 * k], points[3 * k + 1], points[3 * k + 2]} - w.from;
    const double cost = w.border ? -dot(from_mean, w.outwards) : squared(from_mean);
    if (cost < w.best || w.point < 0) w.best = cost, w.point = k;
  }
  for (const Wanted& w : wanted) sample.push_back(w.point);
  std::sort(sample.begin(), sample.end());
  return sample;
}

}  // namespace knotfit
