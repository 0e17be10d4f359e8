// Where along the boundary the corners of the square go: a pattern search.
#pragma once
#include <functional>
#include <vector>

#include "parameterize/mesh_border.h"
namespace knotfit::mesh_map {

struct CornerSearch {
  std::vector<Corners> starts = {};  ///< tried besides eight rotations of equal quarters
  int most_evaluations = 400;
  std::function<bool()> stop = {};  ///< asked before each evaluation
};

/// Corners of the least cost found: from the two best starts, each corner, neighbours and all four
/// move along the border by 1/12 of its length, halved down to 1/300.
Corners search_corners(const Border& border, const CornerSearch& search,
                       const std::function<double(const Corners&)>& cost);

}  // namespace knotfit::mesh_map
