#include "knotfit/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "knotfit/exceptions.h"
namespace knotfit {

Surface::Surface(KnotVector knots_u, KnotVector knots_v, int dimension, std::vector<double> net)
    : knots_u_(std::move(knots_u)),
      knots_v_(std::move(knots_v)),
      dimension_(dimension),
      net_(std::move(net)) {
  if (knots_u_.degree() == 0 || knots_v_.degree() == 0)
    throw InvalidInput("a surface needs a knot vector in u and one in v; one of them is empty");
  if (dimension_ < 1)
    throw InvalidInput(fmt::format("a surface's dimension is {}; it must be >= 1", dimension_));
  const std::size_t wanted =
      static_cast<std::size_t>(size_u() * size_v()) * static_cast<std::size_t>(dimension_);
  if (net_.size() != wanted)
    throw InvalidInput(
        fmt::format("the control net has {} numbers; {} x {} control points of dimension {} need {}",
                    net_.size(), size_u(), size_v(), dimension_, wanted));
  const auto bad = std::find_if(net_.begin(), net_.end(), [](double c) { return !std::isfinite(c); });
  if (bad != net_.end()) {
    const Index at = (bad - net_.begin()) / dimension_;
    throw InvalidInput(fmt::format("control point ({}, {}) has the coordinate {}; it must be finite",
                                   at / size_v(), at % size_v(), *bad));
  }
}

double Surface::scale() const {
  double largest = 0;
  for (double c : net_) largest = std::max(largest, std::abs(c));
  return largest;
}

Surface height_field_in_space(const Surface& height, double x0, double x1, double y0, double y1) {
  return height_field_in_space(height, {x0, y0}, {x1, y0}, {x0, y1});
}

Surface height_field_in_space(const Surface& height, std::array<double, 2> corner_00,
                              std::array<double, 2> corner_10, std::array<double, 2> corner_01) {
  if (height.empty()) throw InvalidInput("the height field is empty");
  if (height.dimension() != 1)
    throw InvalidInput(fmt::format("a height field has dimension 1, not {}", height.dimension()));
  for (const auto& corner : {corner_00, corner_10, corner_01})
    if (!std::isfinite(corner[0]) || !std::isfinite(corner[1]))
      throw InvalidInput(
          fmt::format("a corner ({}, {}) of the height field: it must be finite", corner[0], corner[1]));
  // Greville abscissae reproduce u itself [Piegl97 ch. 9]; the ends come out exact where an axis is not oblique.
  const auto place = [&](double u, double v, int axis) {
    const double a = corner_00[axis], b = corner_10[axis], c = corner_01[axis];
    if (a == c) return (1 - u) * a + u * b;
    if (a == b) return (1 - v) * a + v * c;
    return (1 - u - v) * a + u * b + v * c;
  };
  const std::vector<double> u = height.knots_u().greville(), v = height.knots_v().greville();
  std::vector<double> net;
  net.reserve(height.net().size() * 3);
  for (Index i = 0; i < height.size_u(); ++i)
    for (Index j = 0; j < height.size_v(); ++j) {
      for (int axis : {0, 1}) net.push_back(place(u[i], v[j], axis));
      net.push_back(height.control_point(i, j)[0]);
    }
  return Surface(height.knots_u(), height.knots_v(), 3, std::move(net));
}

Surface transposed(const Surface& s) {
  if (s.empty()) return s;
  std::vector<double> net(s.net().size());
  auto to = net.begin();
  for (Index j = 0; j < s.size_v(); ++j)
    for (Index i = 0; i < s.size_u(); ++i) {
      const auto point = s.control_point(i, j);
      to = std::copy(point.begin(), point.end(), to);
    }
  return Surface(s.knots_v(), s.knots_u(), s.dimension(), std::move(net));
}

}  // namespace knotfit
