// A sample of a cloud without parameters: even in space, with its outline.
#pragma once
#include <span>
#include <vector>

#include "knotfit/index.h"
namespace knotfit {

/// One point of each cell of a cubic grid, the finest that has at most `most` cells with points: the one nearest the mean of
/// its cell; where the cells about it lie to one side, the one farthest out, so that the sample reaches as far as the cloud.
/// Depends on the points and `most` alone.
/// \param points  n x 3, finite
/// \param most  > 0
/// \return indices of points, rising; all of them where there are no more than `most`
std::vector<Index> spaced_sample(std::span<const double> points, Index most);

}  // namespace knotfit
