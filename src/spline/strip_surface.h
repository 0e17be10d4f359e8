// A curve as a surface that does not change along v, so that curves go the way of surfaces.
#pragma once
#include "knotfit/curve.h"
#include "knotfit/surface.h"
namespace knotfit {

/// Degree 1 along v, no knot there.
/// \param dimension  0: the curve's own; more: the rest of the coordinates are 0
Surface strip_surface(const Curve& curve, int dimension = 0);

/// The curve at the start of v. \param closed  its end becomes its start to the last bit
Curve curve_of_strip(const Surface& strip, bool closed);

}  // namespace knotfit
