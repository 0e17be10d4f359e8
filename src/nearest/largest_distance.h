// The largest distance of a surface from a mesh, between the samples of a grid too [METHOD 8.14].
#pragma once
#include <span>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/surface.h"
#include "nearest/triangle_tree.h"
namespace knotfit {

/// Distances at the centres of the cells that cut the square, u.size() x v.size() of them; < 0: not measured, there is no
/// data there.
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

/// Looks beyond the grid's samples: along the sides and at the corners of the square, and inside the cells that may hold
/// more. A cell may hold at most its largest distance seen plus how much those seen in it differ, and no more than its
/// size in space allows (a distance changes no faster than the place does); cells are quartered until none may hold 1 %
/// more than the largest found. Beside places without data nothing is looked at.
/// The same for any number of threads.
LargestDistance largest_distance(const Surface& surface, const TriangleTree& tree, const DistanceGrid& grid,
                                 const Control& control);

}  // namespace knotfit
