// Where to look between the data: its widest gaps and the border.
#pragma once
#include <array>
#include <vector>

#include "data/neighbours.h"
namespace knotfit::verify {

/// Places in [0,1]^2 far from all points, in units of the local spacing; each is the candidate farthest from the
/// points and the places before it. The candidates are one random place in each cell of a grid of step
/// 1/(4 sqrt N), at most 200 cells a side so that the cost does not grow with N, and as many on
/// the border, which counts double. Gaps so wide that they must be holes come last: nothing can be promised there.
/// \param points  neighbours in (u, v)
/// \return `count` places, fewer where there are not as many candidates
std::vector<std::array<double, 2>> gap_places(const Neighbours& points, Index count, unsigned long long seed);

}  // namespace knotfit::verify
