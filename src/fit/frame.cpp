#include "pipeline/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
namespace knotfit {

Frame::Frame(const ParameterizedPoints& points) : centre_(points.dimension) {
  double half = 0, largest = 0;
  for (int d = 0; d < points.dimension; ++d) {
    double low = INFINITY, high = -INFINITY;
    for (Index k = 0; k < points.size(); ++k) {
      low = std::min(low, points.value(k)[d]);
      high = std::max(high, points.value(k)[d]);
    }
    centre_[d] = low / 2 + high / 2;
    half = std::max(half, high / 2 - low / 2);
    largest = std::max({largest, std::abs(low), std::abs(high)});
  }
  if (half > 0) scale_ = std::exp2(std::ceil(std::log2(half)));
  rounding_ = largest * std::numeric_limits<double>::epsilon() / 2;
}

ParameterizedPoints Frame::inside(const ParameterizedPoints& points) const {
  ParameterizedPoints result = points;
  for (Index k = 0; k < points.size(); ++k)
    for (int d = 0; d < points.dimension; ++d) {
      double& x = result.values[k * points.dimension + d];
      x = (x - centre_[d]) / scale_;
    }
  return result;
}

Surface Frame::outside(const Surface& surface) const {
  std::vector<double> net = surface.net();
  const int dimension = surface.dimension();
  for (std::size_t i = 0; i < net.size(); ++i) net[i] = net[i] * scale_ + centre_[i % dimension];
  return Surface(surface.knots_u(), surface.knots_v(), dimension, std::move(net));
}

}  // namespace knotfit
