// Knots under a surface whose parameters move, and the surface over other knots.
#pragma once
#include "knotfit/interior_knots.h"
#include "knotfit/surface.h"
namespace knotfit {

/// Of the mean span: narrower ones have few vertices to hold them.
inline constexpr double kLeastMeshSpan = 0.1;

/// The nearest surface over these knots, of the same degrees, direction by direction.
Surface carried_over(const Surface& s, const KnotVector& u, const KnotVector& v);

/// Halfway from the surface's own knots, spread over the counts, to those that the error model [METHOD 2.1] places on
/// it: what one round of correction can follow.
InteriorKnots knots_anew(const Surface& s, int interior_u, int interior_v);

}  // namespace knotfit
