// Knots under a surface whose parameters move, and the surface over other knots.
#pragma once
#include <optional>
#include <vector>

#include "fit/knot_jacobian.h"
#include "knotfit/interior_knots.h"
#include "knotfit/surface.h"
namespace knotfit {

/// The nearest surface over these knots, of the same degrees, direction by direction.
Surface carried_over(const Surface& s, const KnotVector& u, const KnotVector& v);

/// Halfway from the surface's own knots, spread over the counts, to those that the error model [METHOD 2.1] places on
/// it: what one round of correction can follow.
InteriorKnots knots_anew(const Surface& s, int interior_u, int interior_v);

/// A Levenberg-Marquardt step in the log-spacings of both directions [Jupp78; METHOD 3].
class SpacingsModel {
 public:
  SpacingsModel(const KnotJacobian& jacobian, const InteriorKnots& knots);
  /// \param mu  damping   \return nothing where the matrix is singular
  std::optional<InteriorKnots> moved(double mu) const;

 private:
  InteriorKnots knots_;
  std::vector<double> matrix_, gradient_;
};

}  // namespace knotfit
