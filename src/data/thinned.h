// Fewer of the points, where a sample of them is enough.
#pragma once
#include "knotfit/points.h"
namespace knotfit {

/// Every k-th point, with the least k that leaves at most `most`; their lines in the source are not kept.
ParameterizedPoints thinned(const ParameterizedPoints& points, Index most);

}  // namespace knotfit
