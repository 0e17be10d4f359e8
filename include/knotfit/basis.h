// B-spline basis functions and their derivatives at one parameter.
#pragma once
#include <span>

#include "knotfit/knot_vector.h"
namespace [[gnu::visibility("default")]] knotfit {

/// The degree + 1 basis functions that are not zero on the span, at x [Piegl97 A2.2].
/// They are >= 0 and sum to 1 within 2 degree eps.
/// \param span    from KnotVector::find_span(x)
/// \param values  degree + 1 entries, written; entry a is function span - degree + a
void basis_functions(const KnotVector& knots, Index span, double x, std::span<double> values);

/// The same with derivatives up to `order` of any size; those above the degree are zero
/// [Piegl97 A2.3].
/// \param values  (order + 1) x (degree + 1), row-major: row r holds the r-th derivatives
void basis_derivatives(const KnotVector& knots, Index span, double x, int order, std::span<double> values);

}  // namespace knotfit
