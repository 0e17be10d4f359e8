// Neighbours across the lines that scanners leave: points far denser along a line than from one to the next.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "knotfit/index.h"
namespace knotfit::cloud {

/// Others of a point, nearest first.
struct Nearest {
  std::vector<std::uint32_t> index;
  std::vector<double> squared;  ///< distances
};
/// Finds so many nearest others of the point at hand, or all there are.
using FindNearest = std::function<void(std::size_t count, Nearest& found)>;

/// Where the nearest others of point k lie on one line, takes as many in the metric that makes the distance to the next
/// line as short as that to the next point on this one. Where they spread, and where no other line is near, they stay.
/// \param points   n x 3
/// \param nearest  of point k, in and out; nearest first
void reach_across(std::span<const double> points, Index k, Nearest& nearest, const FindNearest& find);

}  // namespace knotfit::cloud
