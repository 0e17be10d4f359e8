#include "spline/strip_surface.h"

#include <algorithm>
namespace knotfit {

Surface strip_surface(const Curve& curve, int dimension) {
  const int d = curve.dimension(), out = std::max(dimension, d);
  std::vector<double> net;
  for (Index i = 0; i < curve.size(); ++i)
    for (int copy = 0; copy < 2; ++copy)
      for (int e = 0; e < out; ++e) net.push_back(e < d ? curve.control_points()[i * d + e] : 0);
  return Surface(curve.knots(), KnotVector::uniform(1, 0), out, std::move(net));
}

Curve curve_of_strip(const Surface& strip, bool closed) {
  std::vector<double> row;
  for (Index i = 0; i < strip.size_u(); ++i) {
    const auto c = strip.control_point(i, 0);
    row.insert(row.end(), c.begin(), c.end());
  }
  if (closed) std::copy_n(row.begin(), strip.dimension(), row.end() - strip.dimension());
  return Curve(strip.knots_u(), strip.dimension(), std::move(row));
}

}  // namespace knotfit
