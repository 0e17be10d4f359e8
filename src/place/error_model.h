// Iterated error model: knots where the (m+1)-th derivatives are large [deBoor01 NEWNOT; METHOD 2.1].
#pragma once
#include "place/context.h"
namespace knotfit {

/// Density of knots over the spans of one direction, from the jumps of the m-th derivative across
/// the knots of the present fit.
struct ErrorDensity {
  std::vector<double> mass;  ///< a span: floored density times length
  double integral = 1;       ///< of the density, before the floor
};
ErrorDensity error_density_u(const FitProblem& fitted);
ErrorDensity error_density_v(const FitProblem& fitted);

/// Four rounds from these uniform knots; density of the last fit.
FineModel fit_fine_model(FitProblem& problem, const InteriorKnots& uniform, const Control& control);

/// One round's knots at new counts, from the density of the present fit.
InteriorKnots knots_of_density(const FitProblem& fitted, int interior_u, int interior_v);

}  // namespace knotfit
