#include "place/strip.h"

#include <algorithm>
#include <numeric>
namespace knotfit {

ParameterizedPoints strip_of(const CurvePoints& points) {
  std::vector<Index> order(points.t.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return points.t[a] < points.t[b]; });
  const int d = points.dimension, extra = d > 1 ? 1 : 0;
  std::vector<double> t, values, weights;
  for (std::size_t i = 0; i < order.size();) {
    const double at = points.t[order[i]];
    double weight = 0;
    std::vector<double> sum(d, 0.0);
    for (; i < order.size() && points.t[order[i]] == at; ++i) {
      const double w = points.weight(order[i]);
      weight += w;
      for (int e = 0; e < d; ++e) sum[e] += w * points.value(order[i])[e];
    }
    t.push_back(at);
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
