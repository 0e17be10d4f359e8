// Whether knots move on all points or on a sample of them [METHOD 6.4].
#pragma once
#include "knotfit/place.h"
namespace knotfit {

/// Points of the sample that knots are moved on; 0: on all of them.
/// \param control_points  expected of the surface
Index sample_size(Index points, double control_points, Engine engine);

}  // namespace knotfit
