// How the fit changes with its knots, the control points eliminated [Golub73; METHOD 3.1].
#pragma once
#include <vector>

#include "solve/banded_system.h"
namespace knotfit {

/// d basis / d knot on every span: entry [((s * 2m + e) * w + a) * w + i] is the Legendre coefficient a
/// of the derivative of function s + i on span s in interior knot s - m + e (counted from 0 with
/// multiplicity; those below 0 or past the last are zero) [Piegl98].
std::vector<double> knot_derivatives(const Axis& axis);

/// Normal matrix and half gradient of phi = sum w |r|^2 at the minimising control points, in the
/// interior knots of u, then v. Copies of a multiple knot have a column each.
struct KnotJacobian {
  std::size_t knots = 0;
  std::vector<double> matrix;    ///< knots x knots: J^T W J
  std::vector<double> gradient;  ///< knots: J^T W r; d phi / d knot is twice it
};

/// At the net of the system's last residuals() call, which minimises at the knots last factored.
/// \param golub_pereyra  with the exact Jacobian's second term; without it Kaufman's, which finds better
///   optima at two thirds of the cost [METHOD 3.1]
KnotJacobian knot_jacobian(const BandedSystem& system, const std::vector<double>& net,
                           bool golub_pereyra = false);

}  // namespace knotfit
