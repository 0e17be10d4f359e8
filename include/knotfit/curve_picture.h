// Pictures of curves: the curve with its knots, control points and the points it was fitted to.
#pragma once
#include <string>
#include <vector>

#include "knotfit/curve.h"
#include "knotfit/picture.h"
namespace [[gnu::visibility("default")]] knotfit {

struct CurvePictureInput {
  const Curve* curve = nullptr;  ///< planar, in space (seen along its least extent), or one component over t
  std::vector<double> points;    ///< n x dimension; may be empty
  std::vector<double> t;         ///< n, where each point stands on the curve; of one component also its place
  std::vector<double> errors;    ///< n, >= 0: the colours; may be empty
  std::string title, subtitle;
  double x0 = 0, x1 = 1;  ///< of one component: the axis under it
};
/// \throws InvalidInput  another extension, sizes outside 200 to 20000, no curve, lengths that do not fit
std::string draw_curve_picture(const CurvePictureInput& input, const std::string& extension,
                               const PictureOptions& options = {});

}  // namespace knotfit
