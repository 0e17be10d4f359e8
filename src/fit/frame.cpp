#include "fit/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

struct Box {
  std::vector<double> low, high;
  explicit Box(int dimension) : low(dimension, INFINITY), high(dimension, -INFINITY) {}
  void add(const double* x) {
    for (std::size_t d = 0; d < low.size(); ++d)
      low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
  }
  std::vector<double> centre() const {
    std::vector<double> result;
    for (std::size_t d = 0; d < low.size(); ++d) result.push_back(low[d] / 2 + high[d] / 2);
    return result;
  }
  /// Half an ulp of its largest coordinate.
  double rounding() const {
    double largest = 0;
    for (std::size_t d = 0; d < low.size(); ++d)
      largest = std::max({largest, std::abs(low[d]), std::abs(high[d])});
    return largest * std::numeric_limits<double>::epsilon() / 2;
  }
};

}  // namespace

Frame::Frame(const ParameterizedPoints& points) {
  Box box(points.dimension);
  for (Index k = 0; k < points.size(); ++k) box.add(points.value(k));
  double half = 0;
  for (std::size_t d = 0; d < box.low.size(); ++d) half = std::max(half, box.high[d] / 2 - box.low[d] / 2);
  // Its inverse has to be a number too.
  if (half > 0) scale_ = std::max(std::exp2(std::ceil(std::log2(half))), std::numeric_limits<double>::min());
  centre_ = box.centre();
  rounding_ = box.rounding();
}

Frame::Frame(const Mesh& mesh) {
  Box box(3);
  for (const auto& f : mesh.faces)
    for (const std::int32_t k : f) box.add(mesh.vertex(k));
  scale_ = length(at(box.high.data()) - at(box.low.data()));
  if (!(scale_ > 0) || !std::isfinite(scale_))
    throw InvalidInput(
        "all vertices of the mesh are at one place, or too far apart: there is no surface to fit");
  centre_ = box.centre();
  rounding_ = box.rounding();
}

std::vector<double> Frame::scaled(std::span<const double> values) const {
  std::vector<double> result(values.size());
  const double inverse = 1 / scale_;
  for (std::size_t i = 0; i < values.size(); ++i)
    result[i] = inverse * (values[i] - centre_[i % centre_.size()]);
  return result;
}

ParameterizedPoints Frame::inside(const ParameterizedPoints& points) const {
  ParameterizedPoints result = points;
  result.values = scaled(points.values);
  return result;
}

std::vector<Vec3> Frame::inside(const Mesh& mesh) const {
  const std::vector<double> values = scaled(mesh.vertices);
  std::vector<Vec3> places;
  for (std::size_t k = 0; k < values.size(); k += 3) places.push_back(at(&values[k]));
  return places;
}

Surface Frame::inside(const Surface& surface) const {
  return Surface(surface.knots_u(), surface.knots_v(), surface.dimension(), scaled(surface.net()));
}

Surface Frame::outside(const Surface& surface) const {
  std::vector<double> net = surface.net();
  for (std::size_t i = 0; i < net.size(); ++i) net[i] = net[i] * scale_ + centre_[i % centre_.size()];
  return Surface(surface.knots_u(), surface.knots_v(), surface.dimension(), std::move(net));
}

}  // namespace knotfit
