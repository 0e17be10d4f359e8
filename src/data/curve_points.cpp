#include "knotfit/curve_points.h"

#include <fmt/format.h>

#include <cmath>

#include "knotfit/exceptions.h"
namespace knotfit {

void validate(const CurvePoints& points) {
  if (points.closed)
    for (Index k = 0; k < points.size(); ++k)
      if (points.t[k] == 1)
        throw InvalidInput(fmt::format("point {} has the parameter 1: on a closed curve it is 0 again", k));
  if (points.closed && points.function) throw InvalidInput("a function y over x is no closed curve");
  if (points.function && points.dimension != 1)
    throw InvalidInput(fmt::format("a function y over x has one component, not {}", points.dimension));
  validate(on_border(points));
}

ParameterizedPoints on_border(const CurvePoints& points) {
  ParameterizedPoints border;
  border.dimension = points.dimension;
  border.values = points.values;
  border.weights = points.weights;
  border.source = points.source;
  border.uv.reserve(2 * points.t.size());
  for (double t : points.t) border.uv.insert(border.uv.end(), {t, 0.0});
  border.map.name_u = points.function ? "x" : "t";
  if (points.function) {
    border.map.u0 = points.x0;
    border.map.u1 = points.x1;
  }
  return border;
}

}  // namespace knotfit
