// The spline over other knots that is nearest to a surface along u.
#pragma once
#include <vector>

#include "knotfit/surface.h"
namespace knotfit {

struct Projection {
  Surface surface;
  double error = 0;                   ///< bound on the distance to S at equal parameters
  std::vector<double> span_errors{};  ///< the same a span of the new knots' breaks
};

/// Least squares over the domain, both borders u = const kept: the L2 projection onto splines is within a factor
/// of the best approximation in the maximum norm that does not depend on the knots [Shadrin01].
/// \param s      clamped along u
/// \param knots  clamped, the same domain, any degree
Projection project_u(const Surface& s, const KnotVector& knots);

}  // namespace knotfit
