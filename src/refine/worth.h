// Whether optimising knots can pay, found out before it is tried.
#pragma once
#include "place/context.h"
#include "refine/attempts.h"
namespace knotfit {

struct KnotWorth {
  double saving = 0;          ///< share of the control points that optimised knots save against uniform ones
  double control_points = 0;  ///< expected for the tolerance, with them
};

/// From fits of some 10 x 10 and 20 x 20 spans on at most 20 000 of the points: how much optimised knots
/// lower the RMS at equal size, and by what order the error falls with the size.
KnotWorth estimate_worth(const FitProblem& data, const FineModel& fine, const Tolerance& tolerance);

}  // namespace knotfit
