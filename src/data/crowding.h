// Parameters that cannot do: points far closer in them than on the surface [METHOD 5.5].
#pragma once
#include "data/indexed_points.h"
namespace knotfit {

/// Share of the points whose distance to their fourth neighbour is below a quarter of the median in the parameters and above half of
/// the median in space: parts of the surface that the parameters squeeze. A net that resolves them is far too fine for the rest. (Mean
/// value maps of scans with steep parts 3 to 6 %; even data, clusters, steps and ridges below 0.1 %.)
double crowded_share(const IndexedPoints& points);
inline constexpr double kCrowded = 0.01;  ///< from here on a user is told

}  // namespace knotfit
