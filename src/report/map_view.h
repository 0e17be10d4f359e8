// The two panels of a picture of a map: the mesh with its parameter lines, and the parameter plane.
#pragma once
#include <string>

#include "report/canvas.h"
#include "report/map_content.h"
namespace knotfit::report {

/// The mesh, shaded, with the lines the viewer sees, the corners and a triad.
/// \return what it says of itself: the size of the box
std::string draw_mesh_view(Canvas& canvas, const MapContent& content, const Box& panel, double em);

/// The mesh in the rectangle of the map, with the same lines and corners.
/// \return the rectangle on the page
Box draw_map_plane(Canvas& canvas, const MapContent& content, const Box& panel, double em);

/// The mark of a corner of the square.
void draw_corner(Canvas& canvas, Vec2 at, const std::string& name, double em);

}  // namespace knotfit::report
