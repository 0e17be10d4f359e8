// What single and batch evaluation share.
#pragma once
#include "knotfit/surface.h"
namespace knotfit {

/// \throws InvalidInput  the surface is empty or an order negative
void check_evaluation(const Surface& s, int derivative_u, int derivative_v);

/// One derivative at one parameter, nothing checked. \param out  dimension entries, written
void evaluate_one(const Surface& s, double u, double v, int derivative_u, int derivative_v, double* out);

}  // namespace knotfit
