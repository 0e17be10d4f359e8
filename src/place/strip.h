// Curves by the methods of surfaces: a curve is a surface that does not change along v [METHOD 9.1].
#pragma once
#include "knotfit/curve_points.h"
#include "knotfit/place.h"
namespace knotfit {

/// The strip between the curve at v = 0 and the same curve at v = 1. Planar curves and those in space stand on it as
/// on a cylinder: one more component, v itself, which every fit reproduces, so that bending is what it is on the curve.
/// Points of equal t become their mean of summed weight. Least squares on the strip, degree 1 and no knot along v, is
/// least squares on the curve.
ParameterizedPoints strip_of(const CurvePoints& points);

/// Interior knots of [0,1] by any method of the table. \throws InvalidInput  as place_knots
/// \param options  interior_u, degree_u and the method's own count
Placement place_curve_knots(std::string_view method, const CurvePoints& points, PlacementOptions options,
                            const Control& control = {});

}  // namespace knotfit
