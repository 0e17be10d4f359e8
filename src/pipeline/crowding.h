// Parameters that cannot do: most points in a small part of the square, far closer there than in space.
#pragma once
#include "knotfit/points.h"
namespace knotfit {

struct Crowding {
  double share =
      1;  ///< least share of the square's cells (about four points each, were they even) that holds 90 % of the points
  double stretch =
      1;  ///< distance in space over distance in the parameters, 90th over 10th percentile of the points
  /// Nine points in ten crowd a fifth of the square, and the surface stretches ten times more elsewhere: a net that resolves them
  /// there is far too fine for the rest.
  bool crowded() const { return share < 0.2 && stretch > 10; }
};

/// \param points  valid
Crowding measure_crowding(const ParameterizedPoints& points);

}  // namespace knotfit
