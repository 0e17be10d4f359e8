// Clouds over a surface that is given, or spanned by four curves.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/parameterize_cloud.h"
#include "knotfit/surface.h"
namespace [[gnu::visibility("default")]] knotfit {

/// The bilinearly blended surface of four boundary curves [Coons67], bicubic, 20 x 20 spans.
/// \param curves  points of each, n x 3 row-major in order; in the order of the boundary or any other, each in either
///   direction. The first is the side v = 0.
/// \throws InvalidInput  a curve of fewer than 2 points or no length; ends that do not meet: how far they are apart
Surface coons_surface(const std::array<std::vector<double>, 4>& curves);

/// The cloud at the parameters of its closest points on the surface, stretched to the square; beyond the surface's
/// sides its tangents go on.
/// \param points  n x 3
/// \throws InvalidInput  what parameterize_cloud() and closest_points() refuse
CloudMap parameterize_cloud(std::span<const double> points, const Surface& base, const Control& control = {});

}  // namespace knotfit
