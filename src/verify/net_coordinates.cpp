#include "verify/net_coordinates.h"

#include "verify/de_boor.h"
namespace knotfit::verify {

NetCoordinate::NetCoordinate(std::span<const double> interior, double scale)
    : knots_(KnotVector::clamped(3, interior)), scale_(scale) {}

double NetCoordinate::operator()(double u) const {
  const Triangle triangle(knots_, u);
  double c[kMaxDegree + 1];
  for (int j = 0; j <= triangle.degree(); ++j) c[j] = static_cast<double>(triangle.first() + j);
  return triangle.value(c) / scale_;
}

}  // namespace knotfit::verify
