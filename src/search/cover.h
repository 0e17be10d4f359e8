// A greedy cover of the gaps between points [METHOD 4.4].
#pragma once
#include <array>
#include <vector>

#include "data/neighbours.h"
namespace knotfit {

/// Places such that no node of a grid of step 1/(4 sqrt N) over [0,1]^2, border included, is farther than
/// radius/sqrt N (on the border: border_radius/sqrt N) from a point or a place: border nodes first, then
/// those farthest from the points.
std::vector<std::array<double, 2>> cover_gaps(const Neighbours& points, double radius, double border_radius);

}  // namespace knotfit
