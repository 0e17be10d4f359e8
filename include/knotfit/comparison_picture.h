// Pictures of a comparison: error against control points, and every method's knots over its errors.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "knotfit/picture.h"
namespace [[gnu::visibility("default")]] knotfit {

/// One method's line: errors at numbers of control points.
struct ErrorSeries {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< (control points, error), in any order, both > 0
};
/// Both axes logarithmic; a colour and a mark a method, which the key names by their last error.
/// \throws InvalidInput  another extension, sizes outside 200 to 20000, no point at all, one not positive and finite
std::string draw_error_plot(const std::vector<ErrorSeries>& series, const std::string& title,
                            const std::string& quantity, const std::string& extension,
                            const PictureOptions& options = {});

/// One method's panel.
struct ComparedSurface {
  std::string name, remark;  ///< heading, and the figures under it
  const Surface* surface = nullptr;
  std::vector<double> errors;  ///< n, >= 0
};
/// The parameter plane of every surface with its knot lines over its errors, all in one colour scale: pale for no
/// error, full for `range` and more.
/// \param range  > 0, such as error_range() of all that shall be compared
/// \throws InvalidInput  as above, no surface, errors that do not fit the points
std::string draw_error_maps(const std::vector<ComparedSurface>& surfaces, const ParameterizedPoints& points,
                            double range, const std::string& title, const std::string& extension,
                            const PictureOptions& options = {});
/// The 99.5th percentile of all errors together, or the largest where that is 0; 1 where all are 0.
/// \throws InvalidInput  an error that is not finite
double error_range(const std::vector<ComparedSurface>& surfaces);

}  // namespace knotfit
