#include "data/thinned.h"
namespace knotfit {

ParameterizedPoints thinned(const ParameterizedPoints& points, Index most) {
  const Index stride = (points.size() + most - 1) / most;
  ParameterizedPoints few;
  few.dimension = points.dimension;
  few.height_field = points.height_field;
  few.map = points.map;
  for (Index k = 0; k < points.size(); k += stride) {
    few.uv.insert(few.uv.end(), {points.u(k), points.v(k)});
    few.values.insert(few.values.end(), points.value(k), points.value(k) + points.dimension);
    if (!points.weights.empty()) few.weights.push_back(points.weights[k]);
  }
  return few;
}

}  // namespace knotfit
