// Points and figures that the tests of placement methods share.
#pragma once

#include <algorithm>
#include <vector>

#include "knotfit/fit_least_squares.h"
#include "knotfit/points.h"
namespace knotfit::test {

/// A full grid of heights f(u, v).
template <class F>
ParameterizedPoints grid_of(int nu, int nv, const F& f) {
  ParameterizedPoints points;
  points.height_field = true;
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const double u = i / (nu - 1.0), v = j / (nv - 1.0);
      points.uv.insert(points.uv.end(), {u, v});
      points.values.push_back(f(u, v));
    }
  return points;
}

/// How many knots lie between two places.
inline Index inside(const std::vector<double>& knots, double low, double high) {
  return std::count_if(knots.begin(), knots.end(), [&](double x) { return x > low && x < high; });
}

/// RMS error of the cubic least squares on these knots.
inline double rms(const ParameterizedPoints& points, const InteriorKnots& knots) {
  return fit_least_squares(points, KnotVector::clamped(3, knots.u), KnotVector::clamped(3, knots.v))
      .error.rms;
}

}  // namespace knotfit::test
