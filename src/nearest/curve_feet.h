// Foot points on curves [METHOD 9.3].
#pragma once
#include <span>
#include <vector>

#include "knotfit/curve.h"
namespace knotfit {

/// Finds foot points of points near a curve, from parameters near them: foot_points() on the surface that is the curve at
/// every v, with v held. Parameters of an open curve stay in its domain, those of a closed one go round.
/// \param curve   in R^1 to R^3; a closed one is a single period, whose ends meet
/// \param t       n, in the curve's domain, moved; no distance grows
/// \param points  n x dimension
/// \return squared distances
/// \throws InvalidInput  more than three components
std::vector<double> curve_feet(const Curve& curve, bool closed, std::span<const double> points,
                               std::span<double> t);

}  // namespace knotfit
