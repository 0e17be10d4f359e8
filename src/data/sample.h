// A sample of many points that stands for all of them [METHOD 6.4].
#pragma once
#include "knotfit/points.h"
namespace knotfit {

/// About `most` of the points, drawn by cells of a uniform grid: half of them equally many a cell, so that no region goes
/// unseen, half in proportion to what the cell holds. Each weighs in proportion to the points that it stands for, so
/// that sums over the sample are those over all; the mean weight stays. Depends on the points and `most` alone.
/// \param most  > 0
/// \return the points themselves, where there are no more than `most`; lines in the source are not kept
ParameterizedPoints stratified_sample(const ParameterizedPoints& points, Index most);

}  // namespace knotfit
