// Where to look between the data: knot cells that hardly any point sees.
#pragma once
#include <array>
#include <vector>

#include "knotfit/points.h"
#include "knotfit/surface.h"
namespace knotfit::verify {

/// The middles of the surface's knot cells that hold fewer than three points, those with the fewest points first, then the
/// smallest: knots that were moved to lower the error at the points may stand so close that a surface swings between
/// them where no random place falls.
/// \return at most `count` places
std::vector<std::array<double, 2>> cell_places(const Surface& surface, const ParameterizedPoints& points,
                                               Index count);

}  // namespace knotfit::verify
