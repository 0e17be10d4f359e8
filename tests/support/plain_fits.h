// Fits as placement and searches make them: of scattered points, once, and nothing estimated beside.
#pragma once
#include "knotfit/fit_least_squares.h"
namespace knotfit::test {

inline LeastSquaresOptions plain_fits(double smoothing = LeastSquaresOptions{}.smoothing) {
  LeastSquaresOptions options;
  options.smoothing = smoothing;
  options.refinement_steps = 0;
  options.use_grid = false;
  options.estimate_condition = false;
  return options;
}

}  // namespace knotfit::test
