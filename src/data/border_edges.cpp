#include "data/border_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
namespace knotfit {
namespace {

double apart(const double* p, const double* q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// An edge of the border between two places, the lesser first.
struct Side {
  std::int32_t from = 0, to = 0;      // places
  std::array<std::int32_t, 2> end{};  // vertices there
  std::int32_t face = 0;
};

class Matcher {
 public:
  Matcher(const Mesh& mesh, const MeshTopology& topology, double tolerance)
      : mesh_(mesh), tolerance_(tolerance), place_(static_cast<std::size_t>(mesh.vertex_count()), -1) {
    find_places(topology);
    find_sides(topology);
  }

  std::vector<EdgePair> pairs() {
    join_equal();
    if (tolerance_ > 0) join_near();
    return std::move(pairs_);
  }

 private:
  const double* at(std::int32_t place) const { return mesh_.vertex(vertex_[place]); }

  /// Vertices of the border, equal ones together.
  void find_places(const MeshTopology& topology) {
    std::vector<std::int32_t> border;
    for (const MeshEdge& e : topology.edges)
      if (e.count == 1) border.insert(border.end(), {e.a, e.b});
    std::sort(border.begin(), border.end());
    border.erase(std::unique(border.begin(), border.end()), border.end());
    const auto key = [this](std::int32_t v) {
      const double* p = mesh_.vertex(v);
      return std::tuple(p[0] + 0.0, p[1] + 0.0, p[2] + 0.0, v);  // -0 + 0 is 0
    };
    std::sort(border.begin(), border.end(), [&](std::int32_t v, std::int32_t w) { return key(v) < key(w); });
    for (std::size_t k = 0; k < border.size(); ++k) {
      if (k == 0 || apart(mesh_.vertex(border[k]), mesh_.vertex(vertex_.back())) > 0)
        vertex_.push_back(border[k]);
      place_[border[k]] = static_cast<std::int32_t>(vertex_.size()) - 1;
    }
  }

  void find_sides(const MeshTopology& topology) {
    for (const MeshEdge& e : topology.edges) {
      if (e.count != 1) continue;
      Side s{place_[e.a], place_[e.b], {e.a, e.b}, topology.half_edges[e.first] / 3};
      if (s.from == s.to) continue;  // no length: its face's other edges join its ends
      if (s.from > s.to) std::swap(s.from, s.to), std::swap(s.end[0], s.end[1]);
      sides_.push_back(s);
    }
    std::sort(sides_.begin(), sides_.end(), [](const Side& x, const Side& y) {
      return std::tie(x.from, x.to, x.face) < std::tie(y.from, y.to, y.face);
    });
  }

  void join(const Side& x, const Side& y, bool turned) {
    if (x.face == y.face) return;
    pairs_.push_back({x.end, turned ? std::array{y.end[1], y.end[0]} : y.end, {x.face, y.face}});
  }

  /// Sides between the same two places: each with the first and with the one before, since two may be of one face.
  void join_equal() {
    for (std::size_t k = 0, first = 0; k < sides_.size(); ++k) {
      const Side& s = sides_[k];
      if (k == 0 || s.from != sides_[first].from || s.to != sides_[first].to) {
        first = k;
        group_.push_back(k);
        continue;
      }
      join(sides_[first], s, false);
      if (k - 1 > first) join(sides_[k - 1], s, false);
    }
  }

  /// Places by cells as wide as the tolerance; neighbours lie in one of the 27 about a place.
  void sort_into_cells() {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (std::size_t p = 0; p < vertex_.size(); ++p)
      for (int d = 0; d < 3; ++d) {
        low[d] = std::min(low[d], at(static_cast<std::int32_t>(p))[d]);
        high[d] = std::max(high[d], at(static_cast<std::int32_t>(p))[d]);
      }
    for (int d = 0; d < 3; ++d) {
      low_[d] = low[d];
      // Cells are counted exactly in doubles, and one more fits on either side.
      width_ = std::max({width_, tolerance_, 1e-15 * (high[d] - low[d])});
    }
    cell_.resize(vertex_.size());
    for (std::size_t p = 0; p < vertex_.size(); ++p)
      cell_[p] = {cell_of(at(static_cast<std::int32_t>(p))), static_cast<std::int32_t>(p)};
    std::sort(cell_.begin(), cell_.end());
  }

  using Cell = std::array<double, 3>;
  Cell cell_of(const double* p) const {
    Cell cell;
    for (int d = 0; d < 3; ++d) cell[d] = std::floor((p[d] - low_[d]) / width_);
    return cell;
  }

  std::vector<std::int32_t> near(std::int32_t place) const {
    std::vector<std::int32_t> found;
    const Cell home = cell_of(at(place));
    // Cells that differ in the last number alone stand in one run.
    for (double x = home[0] - 1; x <= home[0] + 1; ++x)
      for (double y = home[1] - 1; y <= home[1] + 1; ++y) {
        auto c = std::lower_bound(cell_.begin(), cell_.end(), std::pair(Cell{x, y, home[2] - 1}, -1));
        for (; c != cell_.end() && c->first <= Cell{x, y, home[2] + 1}; ++c)
          if (c->second != place && apart(at(place), at(c->second)) <= tolerance_) found.push_back(c->second);
      }
    return found;
  }

  /// Groups of equal sides whose ends lie near those of another group.
  void join_near() {
    sort_into_cells();
    const auto places = static_cast<std::int32_t>(vertex_.size());
    std::vector<std::vector<std::int32_t>> around(vertex_.size()), beside(vertex_.size());
    for (std::size_t g = 0; g < group_.size(); ++g) {
      around[sides_[group_[g]].from].push_back(static_cast<std::int32_t>(g));
      around[sides_[group_[g]].to].push_back(static_cast<std::int32_t>(g));
    }
    std::vector<Index> work(vertex_.size(), 0);  // groups to look at from each place
    bool any = false;
    for (std::int32_t p = 0; p < places; ++p) {
      beside[p] = near(p);
      any = any || !beside[p].empty();
      work[p] = static_cast<Index>(around[p].size());
      for (const std::int32_t q : beside[p]) work[p] += static_cast<Index>(around[q].size());
    }
    if (!any) return;
    const auto is_near = [&](std::int32_t p, std::int32_t q) { return apart(at(p), at(q)) <= tolerance_; };
    for (std::size_t g = 0; g < group_.size(); ++g) {
      const Side& s = sides_[group_[g]];
      const std::int32_t end = work[s.from] <= work[s.to] ? s.from : s.to, other = s.from + s.to - end;
      const auto look = [&](std::int32_t q) {
        for (const std::int32_t h : around[q]) {
          if (h == static_cast<std::int32_t>(g)) continue;
          const Side& t = sides_[group_[h]];
          const std::int32_t far = t.from + t.to - q;
          if (!is_near(other, far)) continue;
          const double most = std::max(apart(at(end), at(q)), apart(at(other), at(far)));
          if (most <= 0.5 * std::min(apart(at(s.from), at(s.to)), apart(at(t.from), at(t.to))))
            join_groups(g, static_cast<std::size_t>(h), (end == s.from) != (q == t.from));
        }
      };
      look(end);
      for (const std::int32_t q : beside[end]) look(q);
    }
  }

  std::size_t group_end(std::size_t g) const { return g + 1 < group_.size() ? group_[g + 1] : sides_.size(); }

  /// Both groups have all their sides joined among themselves, but where one face has two of them.
  void join_groups(std::size_t g, std::size_t h, bool turned) {
    for (std::size_t i = group_[g]; i < group_end(g); ++i)
      for (std::size_t j = group_[h]; j < group_end(h); ++j)
        if (i == group_[g] || j == group_[h]) join(sides_[i], sides_[j], turned);
  }

  const Mesh& mesh_;
  double tolerance_;
  std::vector<std::int32_t> place_, vertex_;  // of each vertex; a vertex of each place
  std::vector<Side> sides_;
  std::vector<std::size_t> group_;  // first side between two places
  double low_[3] = {0, 0, 0}, width_ = 0;
  std::vector<std::pair<Cell, std::int32_t>> cell_;
  std::vector<EdgePair> pairs_;
};

}  // namespace

std::vector<EdgePair> equal_border_edges(const Mesh& mesh, const MeshTopology& topology, double tolerance) {
  return Matcher(mesh, topology, tolerance).pairs();
}

}  // namespace knotfit
