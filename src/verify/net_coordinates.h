// Coordinates that stretch with the knots of a net.
#pragma once
#include <span>
#include <vector>

#include "knotfit/knot_vector.h"
namespace knotfit::verify {

/// xi(u) = sum_i i B_i(u) of cubic B-splines on interior knots, over a common scale: a step along an
/// axis is smooth in it where the knots of an error-model net stand close.
class NetCoordinate {
 public:
  /// \param scale  xi is divided by it; the largest index of a basis function makes xi(1) = 1
  /// \throws InvalidInput  as KnotVector::clamped
  NetCoordinate(std::span<const double> interior, double scale);
  double operator()(double u) const;

 private:
  KnotVector knots_;
  double scale_;
};

/// Largest index of a cubic B-spline on so many interior knots.
inline double net_scale(std::size_t interior) {
  return static_cast<double>(interior) + 3;
}

}  // namespace knotfit::verify
