// What a curve's fit is asked for, as the library's options.
#pragma once
#include "knotfit/fit_curve.h"
#include "options.h"
namespace knotfit::tool {

CurveFitOptions curve_options(const Arguments& arguments);

}  // namespace knotfit::tool
