// The order in which the vertices of a mesh leave a linear system, found once for every system on it.
#pragma once
#include <array>
#include <span>
#include <vector>

namespace knotfit::mesh_map {

/// A front: consecutive vertices eliminated together, and the later ones they touch [Duff83].
struct Front {
  int first = 0, width = 0;      ///< places of its own vertices: first .. first + width - 1
  int parent = -1;               ///< front that takes its update; -1: none
  std::vector<int> rows;         ///< places of all its vertices, own ones first, increasing
  std::vector<int> into_parent;  ///< where rows[width + k] stands in the parent's rows
};

/// Where an edge's entries stand in a front.
struct EdgeEntry {
  int edge;
  int row, column;  ///< in the front's rows; column < width
  bool forward;     ///< the row is the edge's first vertex
};

/// Approximate minimum degree order, elimination tree and fronts of a symmetric pattern: a diagonal
/// and one entry each way an edge. For factors without pivoting.
class Elimination {
 public:
  Elimination(int vertices, std::span<const std::array<int, 2>> edges);
  int vertex_count() const { return static_cast<int>(vertex_.size()); }
  int edge_count() const { return edge_count_; }
  int vertex(int place) const { return vertex_[place]; }
  const std::vector<Front>& fronts() const { return fronts_; }  ///< children before parents
  /// Entries of the edges that enter front f.
  std::span<const EdgeEntry> entries(int f) const {
    return std::span(entries_).subspan(entry_start_[f], entry_start_[f + 1] - entry_start_[f]);
  }

 private:
  void find_order(int vertices, std::span<const std::array<int, 2>> edges);
  void find_fronts(std::span<const std::array<int, 2>> edges);
  void link_fronts();
  void place_entries(std::span<const std::array<int, 2>> edges);
  int edge_count_ = 0;
  std::vector<int> vertex_, place_;  ///< vertex at a place, place of a vertex
  std::vector<Front> fronts_;
  std::vector<int> front_of_;  ///< by place
  std::vector<EdgeEntry> entries_;
  std::vector<std::size_t> entry_start_;
};

}  // namespace knotfit::mesh_map
