// Sizes of a curve: up by a tenth until one holds, then down one at a time [METHOD 9.4].
#pragma once
#include <vector>

#include "search/curve_fitter.h"
namespace knotfit {

struct CurveSearch {
  Status status = Status::not_run;
  FittedCurve
      best;  ///< the fewest control points that hold, else the nearest of those that keep to their data
  std::vector<SizeTried> tried;
};

/// \param tolerance  in the frame of the fitter's points
/// \param most       control points
/// \param noise      standard deviation found in the data, in the frame; 0: none
/// \param unit       of the frame, in which errors are listed and shown
CurveSearch search_curve_sizes(CurveFitter& fitter, const CurvePoints& points, const SearchOptions& options,
                               const Tolerance& tolerance, Index most, double noise, double unit,
                               const Control& control);

}  // namespace knotfit
