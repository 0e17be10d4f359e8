// The largest distance from a surface to a mesh, between the samples of a grid too [METHOD 8.14].
#pragma once
#include <span>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/surface.h"
#include "nearest/triangle_tree.h"
namespace knotfit {

/// Distances at the centres of u.size() x v.size() cells that make up the square. Below 0: there is no data, and nothing
/// was measured.
struct DistanceGrid {
  std::span<const double> u, v;
  std::span<const double> distance;
  std::span<const double> point;  ///< of the surface, three each
};

struct LargestDistance {
  double distance = 0, u = 0, v = 0;
  double point[3] = {0, 0, 0};
  bool stopped = false;
};

/// Looks beyond the grid's samples: along the sides of the square, at its corners, and inside cells that may hold more. A
/// cell may hold its largest distance seen plus the difference of those seen in it, or plus its size in space where that is
/// less: a distance changes no faster than the place does. Such cells are quartered until none may hold 1 % more than the
/// largest distance found. Cells beside places without data are left out. The same for any number of threads.
LargestDistance largest_distance(const Surface& surface, const TriangleTree& tree, const DistanceGrid& grid,
                                 const Control& control);

}  // namespace knotfit
