#include "nearest/largest_distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "base/stage.h"
#include "base/vec3.h"
#include "knotfit/evaluate.h"
namespace knotfit {
namespace {

constexpr double kKnown = 0.01;  // of the largest distance: a cell that may hold no more beyond it is done
constexpr double kUnseen =
    2;  // times the differences of the distances around a cell of the grid: what it may hold beyond them
constexpr int kMostLevels = 14;        // of quarters
constexpr Index kMostCells = 200'000;  // of a level: those that may hold most are taken

struct Cell {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  double bound = 0;
};

class Search {
 public:
  Search(const Surface& surface, const TriangleTree& tree, const DistanceGrid& grid)
      : surface_(surface),
        tree_(tree),
        grid_(grid),
        n_u_(static_cast<Index>(grid.u.size())),
        n_v_(static_cast<Index>(grid.v.size())),
        edge_u_(edges(grid.u, surface.knots_u())),
        edge_v_(edges(grid.v, surface.knots_v())) {}

  LargestDistance run(const Control& control) {
    for (Index q = 0; q < n_u_ * n_v_; ++q)
      if (grid_.distance[q] > best_.distance) take(q / n_v_, q % n_v_);
    look_at_sides();
    std::vector<Cell> cells = first_cells();
    Stage stage(control, "distance to the mesh");
    for (int level = 0; level < kMostLevels; ++level) {
      keep_those_that_may_hold_more(cells);
      if (cells.empty()) break;
      best_.stopped = stage.report(1);
      if (best_.stopped) break;
      cells = quartered(cells);
    }
    return best_;
  }

 private:
  /// Cell k reaches from edge k to the next.
  static std::vector<double> edges(std::span<const double> centres, const KnotVector& knots) {
    std::vector<double> edge{knots.first()};
    for (std::size_t k = 0; k + 1 < centres.size(); ++k) edge.push_back(0.5 * (centres[k] + centres[k + 1]));
    edge.push_back(knots.last());
    return edge;
  }
  double distance(Index i, Index j) const { return grid_.distance[i * n_v_ + j]; }
  bool has_data(Index i, Index j) const {
    for (Index a = std::max<Index>(0, i - 1); a <= std::min(n_u_ - 1, i + 1); ++a)
      for (Index b = std::max<Index>(0, j - 1); b <= std::min(n_v_ - 1, j + 1); ++b)
        if (distance(a, b) < 0) return false;
    return true;
  }
  void take(Index i, Index j) {
    best_.distance = distance(i, j);
    best_.u = grid_.u[i], best_.v = grid_.v[j];
    std::copy_n(&grid_.point[3 * (i * n_v_ + j)], 3, best_.point);
  }

  struct Seen {
    std::vector<double> distance, point;
  };
  /// \param uv  two numbers a place
  Seen at_places(const std::vector<double>& uv) const {
    Seen seen{{}, evaluate(surface_, uv)};
    const auto n = static_cast<Index>(uv.size()) / 2;
    seen.distance.resize(static_cast<std::size_t>(n));
    parallel_chunks(n, [&](Index, Index begin, Index end) {
      Index hint = -1;
      for (Index k = begin; k < end; ++k) {
        const TriangleHit hit = tree_.nearest(at(&seen.point[3 * k]), hint);
        seen.distance[k] = std::sqrt(hit.squared);
        hint = hit.face;
      }
    });
    return seen;
  }
  void take_largest(const std::vector<double>& uv, const Seen& seen) {
    for (std::size_t k = 0; k < seen.distance.size(); ++k)
      if (seen.distance[k] > best_.distance) {
        best_.distance = seen.distance[k];
        best_.u = uv[2 * k], best_.v = uv[2 * k + 1];
        std::copy_n(&seen.point[3 * k], 3, best_.point);
      }
  }

  /// Measures the middles and ends of the cells along the sides. What a cell shows there counts in its differences.
  void look_at_sides() {
    side_.assign(static_cast<std::size_t>(n_u_ * n_v_), -1);
    std::vector<double> uv;
    std::vector<Index> cell;
    const auto add = [&](double u, double v, Index i, Index j) {
      uv.insert(uv.end(), {u, v});
      cell.push_back(i * n_v_ + j);
    };
    for (Index i = 0; i < n_u_; ++i)
      for (const Index j : {Index{0}, n_v_ - 1})
        if (has_data(i, j))
          for (const double u : {grid_.u[i], edge_u_[i], edge_u_[i + 1]})
            add(u, j == 0 ? edge_v_.front() : edge_v_.back(), i, j);
    for (Index j = 0; j < n_v_; ++j)
      for (const Index i : {Index{0}, n_u_ - 1})
        if (has_data(i, j))
          for (const double v : {grid_.v[j], edge_v_[j], edge_v_[j + 1]})
            add(i == 0 ? edge_u_.front() : edge_u_.back(), v, i, j);
    const Seen seen = at_places(uv);
    take_largest(uv, seen);
    for (std::size_t k = 0; k < cell.size(); ++k) side_[cell[k]] = std::max(side_[cell[k]], seen.distance[k]);
  }

  /// The cells with data around them, with what they may hold by their neighbours.
  std::vector<Cell> first_cells() const {
    std::vector<double> bound(static_cast<std::size_t>(n_u_ * n_v_), -1);
    parallel_for(n_u_, [&](Index i) {
      for (Index j = 0; j < n_v_; ++j) {
        if (!has_data(i, j)) continue;
        const Index q = i * n_v_ + j;
        double low = distance(i, j), high = low, reach = 0;
        for (Index a = std::max<Index>(0, i - 1); a <= std::min(n_u_ - 1, i + 1); ++a)
          for (Index b = std::max<Index>(0, j - 1); b <= std::min(n_v_ - 1, j + 1); ++b) {
            low = std::min(low, distance(a, b)), high = std::max(high, distance(a, b));
            reach = std::max(reach, length(at(&grid_.point[3 * (a * n_v_ + b)]) - at(&grid_.point[3 * q])));
          }
        if (side_[q] >= 0) low = std::min(low, side_[q]), high = std::max(high, side_[q]);
        bound[q] = std::max(distance(i, j), side_[q]) + std::min(kUnseen * (high - low), reach);
      }
    });
    std::vector<Cell> cells;
    for (Index q = 0; q < n_u_ * n_v_; ++q)
      if (bound[q] > (1 + kKnown) * best_.distance)
        cells.push_back(
            {edge_u_[q / n_v_], edge_u_[q / n_v_ + 1], edge_v_[q % n_v_], edge_v_[q % n_v_ + 1], bound[q]});
    return cells;
  }

  void keep_those_that_may_hold_more(std::vector<Cell>& cells) const {
    std::erase_if(cells, [&](const Cell& c) { return !(c.bound > (1 + kKnown) * best_.distance); });
    if (static_cast<Index>(cells.size()) <= kMostCells / 4) return;
    std::stable_sort(cells.begin(), cells.end(),
                     [](const Cell& a, const Cell& b) { return a.bound > b.bound; });
    cells.resize(static_cast<std::size_t>(kMostCells / 4));
  }

  /// Measures nine places of each cell, and gives its quarters with what they may hold.
  std::vector<Cell> quartered(const std::vector<Cell>& cells) {
    std::vector<double> uv;
    for (const Cell& c : cells)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          uv.insert(uv.end(), {a == 1   ? 0.5 * (c.u0 + c.u1)
                               : a == 0 ? c.u0
                                        : c.u1,
                               b == 1   ? 0.5 * (c.v0 + c.v1)
                               : b == 0 ? c.v0
                                        : c.v1});
    const Seen seen = at_places(uv);
    take_largest(uv, seen);
    std::vector<Cell> quarters;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const double* d = &seen.distance[9 * k];
      const auto [low, high] = std::minmax_element(d, d + 9);
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
          // The quarter's corners among the nine places.
          const int corner[4] = {3 * a + b, 3 * a + b + 1, 3 * a + b + 3, 3 * a + b + 4};
          double largest = 0, across = 0;
          for (const int p : corner) {
            largest = std::max(largest, d[p]);
            for (const int q : corner)
              across = std::max(across,
                                length(at(&seen.point[3 * (9 * k + p)]) - at(&seen.point[3 * (9 * k + q)])));
          }
          const double* place = &uv[2 * (9 * k)];
          quarters.push_back({place[2 * corner[0]], place[2 * corner[3]], place[2 * corner[0] + 1],
                              place[2 * corner[3] + 1], largest + std::min(*high - *low, across)});
        }
    }
    return quarters;
  }

  const Surface& surface_;
  const TriangleTree& tree_;
  const DistanceGrid& grid_;
  Index n_u_, n_v_;
  std::vector<double> edge_u_, edge_v_;
  std::vector<double> side_;  ///< largest distance seen on the sides, by cell; -1: none
  LargestDistance best_;
};

}  // namespace

LargestDistance largest_distance(const Surface& surface, const TriangleTree& tree, const DistanceGrid& grid,
                                 const Control& control) {
  return Search(surface, tree, grid).run(control);
}

}  // namespace knotfit
