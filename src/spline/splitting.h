// A surface cut into pieces along lines u = const.
#pragma once
#include <span>
#include <vector>

#include "knotfit/surface.h"
namespace knotfit {

/// The pieces between the cuts, in order; together they are S. Neighbours share the control points of the line
/// between them, unless S jumps there.
/// \param s     clamped along u
/// \param cuts  increasing, inside the domain
std::vector<Surface> split_u(const Surface& s, std::span<const double> cuts);

}  // namespace knotfit
