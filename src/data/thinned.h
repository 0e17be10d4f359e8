// Fewer of the points, where a sample of them is enough.
#pragma once
#include <span>

#include "knotfit/points.h"
namespace knotfit {

/// The points of these indices, in their order; their lines in the source are not kept.
ParameterizedPoints picked(const ParameterizedPoints& points, std::span<const Index> index);

/// Every k-th point, with the least k that leaves at most `most`; their lines in the source are not kept.
ParameterizedPoints thinned(const ParameterizedPoints& points, Index most);

}  // namespace knotfit
