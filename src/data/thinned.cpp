#include "data/thinned.h"

#include <vector>
namespace knotfit {

ParameterizedPoints picked(const ParameterizedPoints& points, std::span<const Index> index) {
  ParameterizedPoints few;
  few.dimension = points.dimension;
  few.height_field = points.height_field;
  few.map = points.map;
  few.uv.reserve(2 * index.size());
  few.values.reserve(static_cast<std::size_t>(points.dimension) * index.size());
  for (Index k : index) {
    few.uv.insert(few.uv.end(), {points.u(k), points.v(k)});
    few.values.insert(few.values.end(), points.value(k), points.value(k) + points.dimension);
    if (!points.weights.empty()) few.weights.push_back(points.weights[k]);
  }
  return few;
}

ParameterizedPoints thinned(const ParameterizedPoints& points, Index most) {
  const Index stride = (points.size() + most - 1) / most;
  std::vector<Index> index;
  for (Index k = 0; k < points.size(); k += stride) index.push_back(k);
  return picked(points, index);
}

}  // namespace knotfit
