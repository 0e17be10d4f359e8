// A result in a sentence.
#pragma once
#include <string>

#include "knotfit/fit_curve.h"
#include "knotfit/fit_surface.h"
namespace knotfit {

/// The status with its figures. \param points  their number
std::string message_of(const FitResult& result, Index points);
std::string message_of(const CurveFitResult& result, Index points);

}  // namespace knotfit
