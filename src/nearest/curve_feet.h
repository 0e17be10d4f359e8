// Foot points on curves [METHOD 9.3].
#pragma once
#include <span>
#include <vector>

#include "knotfit/curve.h"
namespace knotfit {

/// Foot points of points near a curve, from parameters near them: foot_points() on the surface that the curve makes
/// where it does not change along v, with v held. An open curve's stay in its domain, a closed one's go round.
/// \param curve   in R^1 to R^3; of a closed one a single period, whose ends meet
/// \param t       n, in the curve's domain, moved; no distance grows
/// \param points  n x dimension
/// \return squared distances
/// \throws InvalidInput  more than three components
std::vector<double> curve_feet(const Curve& curve, bool closed, std::span<const double> points,
                               std::span<double> t);

}  // namespace knotfit
