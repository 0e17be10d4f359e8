// The boundary of a disk mesh on the sides of the unit square.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "parameterize/mesh_rest.h"
namespace knotfit::mesh_map {

/// Places of the four corners along DiskMesh::loop, cyclically increasing: (0,0), (1,0), (1,1), (0,1).
using Corners = std::array<int, 4>;

class Border {
 public:
  Border(const DiskMesh& disk, const std::vector<RestTriangle>& rest);
  int size() const { return static_cast<int>(length_.size()); }
  double total() const { return sum_.back(); }
  double at(int k) const { return sum_[k]; }         ///< arc length from loop[0] to loop[k]
  double length(int k) const { return length_[k]; }  ///< from loop[k] to loop[k + 1]
  /// The place nearest to an arc length, around the loop.
  int nearest(double arc) const;
  /// The edge an arc length falls on, and how far along it (0 to 1).
  int edge_at(double arc, double& along) const;
  /// Multiplies the length of every edge.
  void stretch(std::span<const double> factors);
  /// Parameters of the boundary vertices: each side of the square by arc length.
  void place(const Corners& corners, std::span<double> uv) const;
  const DiskMesh& disk() const { return disk_; }

 private:
  void add_up();
  const DiskMesh& disk_;
  std::vector<double> length_, sum_;
};

/// The four sharpest convex turns of the boundary: angle of the chords 2 % of its length either way,
/// corners at least 8 % apart (nearer where four do not fit).
Corners sharpest_corners(const Border& border);

/// The corners moved to boundary vertices of a single face within 2 % of the border's length: elsewhere
/// on a side such a face goes flat.
Corners corners_at_ears(const Border& border, Corners corners);

/// Bit 0: u is fixed to its side, bit 1: v is; a vertex each, from the border's parameters.
std::vector<char> fixed_coordinates(const DiskMesh& disk, std::span<const double> uv);

}  // namespace knotfit::mesh_map
