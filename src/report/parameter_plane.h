// The right panel: the parameter plane with knot lines, points by their error, thin places.
#pragma once
#include "report/canvas.h"
#include "report/content.h"
namespace knotfit::report {

/// Width over height of the plane: that of a height field's x and y within 1 to 2, else square.
double plane_aspect(const Content& content);

/// \param axes  ticks and names of the user's parameters
/// \return the rectangle of the domain on the page
Box draw_parameter_plane(Canvas& canvas, const Content& content, const Box& panel, double em, bool axes);

}  // namespace knotfit::report
