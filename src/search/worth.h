// Whether optimising knots can pay, found out before it is tried [METHOD 4.5].
#pragma once
#include "place/context.h"
namespace knotfit {

struct KnotWorth {
  double saving = 0;          ///< share of the control points that optimised knots save against uniform ones
  double control_points = 0;  ///< expected for the tolerance, with them
};

/// From fits of some 10 x 10 and 20 x 20 spans on at most 20 000 of the points: how much optimised knots
/// lower the RMS at equal size, and by what order the error falls with the size.
/// \param thorough  relocation too: some hundred fits more, and it sees what steps from one start do not (points
/// clustered 30:1 on a ridge: 84 % saved and 4 000 control points in place of 0 % and 18 000; 360 do)
KnotWorth estimate_worth(const FitProblem& data, const FineModel& fine, const Tolerance& tolerance,
                         bool thorough);

}  // namespace knotfit
