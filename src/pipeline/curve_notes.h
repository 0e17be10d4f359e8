// What a user should know of a fitted curve.
#pragma once
#include <string>
#include <vector>

#include "knotfit/fit_curve.h"
namespace knotfit {

/// Notes of a curve over its points: a part without data (longer than 8 steps between points in the median and than
/// kLongGap of the curve), and ends that are one point.
std::vector<std::string> curve_notes(const CurveFitResult& fit, const CurvePoints& points);

}  // namespace knotfit
