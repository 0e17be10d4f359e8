// A surface in the form that CAD systems digest.
#pragma once
#include <vector>

#include "knotfit/surface.h"
namespace [[gnu::visibility("default")]] knotfit {

struct CadSafe {
  int degree = 3;                   ///< 1 to 9; raised to it, or approximated within `tolerance`
  double tolerance = 0;             ///< what reduction and merging may move the surface by; 0: refuse both
  Index most_control_points = 250;  ///< a direction, a face; at least 2 degree
  double least_knot_distance =
      1e-7;  ///< of the domain, in [0, 0.1]: nearer knots are merged within `tolerance`
};
/// Faces of one degree, C1 inside, with at most so many control points a direction and no knots closer than CAD
/// tolerance. Their union is the surface: exactly (to rounding) where the degree is raised, else within
/// `tolerance`. Faces lie in a grid, u slowest; neighbours share their border's control points and knots.
/// Where the surface jumps, or has a fold (a knot of full multiplicity), faces end.
/// \throws InvalidInput  options out of range, or a reduction or merge that `tolerance` does not allow: says by
///   how much it would move the surface
std::vector<Surface> cad_safe(const Surface& surface, const CadSafe& options = {});

}  // namespace knotfit
