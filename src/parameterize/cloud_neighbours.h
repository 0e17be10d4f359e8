// Nearest neighbours in space, and the planes through them.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "knotfit/index.h"
namespace knotfit::cloud {

using Vector = std::array<double, 3>;
inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Two unit vectors that make a right-handed frame with a unit vector; the first as near to x as may be, or to y.
std::array<Vector, 2> frame_of(const Vector& axis);

/// The nearest others of every point, nearest first: count a point.
struct NeighbourLists {
  int count = 0;
  std::vector<std::uint32_t> index;  ///< n x count
  std::vector<double> squared;       ///< n x count, squared distances
  const std::uint32_t* of(Index k) const { return index.data() + k * count; }
};
/// \param points  n x dimension, 2 or 3; n > count
NeighbourLists nearest_neighbours(std::span<const double> points, int dimension, int count);

/// The same in space, but where points lie in lines far denser along than across, as scanners leave them: there in the
/// metric that makes both spacings equal, so that the lines beside a point's own are among its neighbours; by growing
/// distance all the same. A point whose neighbours spread keeps the nearest.
/// \param points  n x 3; n > count
NeighbourLists neighbours_across_lines(std::span<const double> points, int count);

/// Centre and principal axes: the variances along them, growing.
struct Axes {
  Vector centre{}, axis[3];
  double variance[3] = {0, 0, 0};
};
/// \param points  n x 3   \param index  those that count, or empty: all
Axes principal_axes(std::span<const double> points, std::span<const std::uint32_t> index = {});

/// Unit normals by the plane through each point's neighbours, turned to agree along a spanning tree of the
/// neighbours whose normals agree most [Hoppe92, Konig09].
std::vector<Vector> agreeing_normals(std::span<const double> points, const NeighbourLists& neighbours);

/// The same, turned to the side that most of the given normals point to; where one is given it is taken instead.
/// \param given  n x 3 of any length, 0: unknown; or empty
std::vector<Vector> agreeing_normals(std::span<const double> points, const NeighbourLists& neighbours,
                                     std::span<const double> given);

}  // namespace knotfit::cloud
