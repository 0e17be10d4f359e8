// Degree elevation: the same surface with a higher degree.
#pragma once
#include "knotfit/surface.h"
namespace knotfit {

/// S with the degree along u raised to `degree`; each knot's multiplicity grows with it, so that continuity stays.
/// \param s  clamped along u, without a jump there (no interior multiplicity of degree + 1)
/// \throws InvalidInput  degree below that of S or above kMaxDegree, or S as it must not be
Surface elevated_u(const Surface& s, int degree);

}  // namespace knotfit
