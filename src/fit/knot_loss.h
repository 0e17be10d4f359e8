// What the fit loses without one of its knots, for all knots of a direction at once [METHOD 3.3].
#pragma once
#include <vector>

#include "fit/moving_fit.h"
namespace knotfit {

/// Rise of phi (smoothing terms included) when each interior knot of one direction is dropped, the others
/// kept, from the present solve: no new fit. Copies of a multiple knot are dropped one at a time.
///
/// The nets that need no knot are those with d^T c = 0, d the functional that knot insertion leaves out
/// [Boehm80]; minimising under that constraint costs z^T (C G^-1 C^T)^-1 z, z = C c [Golub13 6.2.3].
std::vector<double> knot_losses(const MovingFit& fitted, bool along_v);

/// The functional: entries d_i of functions first..first+size-1 that vanish on every spline without the knot.
struct KnotFunctional {
  Index first = 0;
  std::vector<double> entry;  ///< at most degree + 2, the largest of absolute value 1
};
/// \param knot  index of an interior knot, counted from 0 with multiplicity
KnotFunctional knot_functional(const KnotVector& knots, Index knot);

}  // namespace knotfit
