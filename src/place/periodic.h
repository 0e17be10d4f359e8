// Knots of closed curves that minimise the error: what `optimal` does beyond the cut-open curve [METHOD 9.2].
#pragma once
#include <functional>
#include <vector>

#include "fit/curve_problem.h"
namespace knotfit {

/// Levenberg-Marquardt on the log-spacings of the period and on where its seam stands, control points eliminated, the
/// Jacobian by differences of the solved residual (the exact one of variable projection); then knots moved across the
/// others as relocate_knots does. The problem holds the fit of the result.
/// \param knots  one period; at least degree + 1   \return phi there
double optimize_period(CurveProblem& problem, std::vector<double>& knots,
                       const std::function<bool()>& stop = {});

}  // namespace knotfit
