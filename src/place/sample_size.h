// Whether knots move on all points or on a sample of them [METHOD 6.4].
#pragma once
#include "knotfit/place.h"
namespace knotfit {

/// Points that knots of so many control points are placed or moved on, at least.
double points_needed(double control_points);

/// Points of the sample for them; 0: all points.
/// \param control_points  expected of the surface
Index sample_size(Index points, double control_points, Engine engine);

}  // namespace knotfit
