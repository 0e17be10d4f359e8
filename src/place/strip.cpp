#include "place/strip.h"

#include <algorithm>

#include "data/parameter_groups.h"
namespace knotfit {

ParameterizedPoints strip_of(const CurvePoints& points) {
  const ParameterGroups groups = group_by_parameter(points.t);
  const int d = points.dimension, extra = d > 1 ? 1 : 0;
  std::vector<double> t, values, weights;
  for (Index g = 0; g < groups.size(); ++g) {
    double weight = 0;
    std::vector<double> sum(d, 0.0);
    for (const Index k : groups.group(g)) {
      const double w = points.weight(k);
      weight += w;
      for (int e = 0; e < d; ++e) sum[e] += w * points.value(k)[e];
    }
    t.push_back(points.t[groups.group(g).front()]);
    weights.push_back(weight);
    for (double x : sum) values.push_back(x / weight);
  }
  if (points.closed && t.front() == 0) {  // cut open, its start is its end too
    t.push_back(1);
    weights.push_back(weights.front());
    for (int e = 0; e < d; ++e) values.push_back(values[e]);
  }
  ParameterizedPoints strip;
  strip.dimension = d + extra;
  strip.height_field = d == 1;
  for (std::size_t k = 0; k < t.size(); ++k)
    for (double v : {0.0, 1.0}) {
      strip.uv.insert(strip.uv.end(), {t[k], v});
      strip.values.insert(strip.values.end(), values.begin() + static_cast<Index>(k) * d,
                          values.begin() + static_cast<Index>(k + 1) * d);
      if (extra > 0) strip.values.push_back(v);
      strip.weights.push_back(weights[k]);
    }
  if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 1; })) strip.weights.clear();
  return strip;
}

Placement place_curve_knots(std::string_view method, const CurvePoints& points, PlacementOptions options,
                            const Control& control) {
  options.interior_v = 0;
  options.degree_v = 1;
  return place_knots(method, strip_of(points), options, control);
}

}  // namespace knotfit
