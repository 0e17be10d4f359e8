// Surfaces and points that the report's tests draw.
#pragma once
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "knotfit/picture.h"
namespace knotfit::scenes {

/// A bicubic height field with coefficients f at the Greville abscissae.
inline Surface heights(const std::function<double(double, double)>& f, int interior = 3) {
  const KnotVector knots = KnotVector::uniform(3, interior);
  std::vector<double> net;
  for (double u : knots.greville())
    for (double v : knots.greville()) net.push_back(f(u, v));
  return Surface(knots, knots, 1, net);
}

/// A bicubic surface in space with control points f at the Greville abscissae.
inline Surface in_space(const std::function<std::vector<double>(double, double)>& f, int interior = 3) {
  const KnotVector knots = KnotVector::uniform(3, interior);
  std::vector<double> net;
  int dimension = 0;
  for (double u : knots.greville())
    for (double v : knots.greville()) {
      const std::vector<double> p = f(u, v);
      dimension = static_cast<int>(p.size());
      net.insert(net.end(), p.begin(), p.end());
    }
  return Surface(knots, knots, dimension, net);
}

inline double hills(double u, double v) {
  return std::sin(5 * u) * std::cos(4 * v) + 0.3 * u;
}

/// n random places with values 0; the errors are made up by the tests.
inline ParameterizedPoints random_points(Index n, int dimension = 1, unsigned long long seed = 7) {
  ParameterizedPoints points;
  points.dimension = dimension;
  points.height_field = dimension == 1;
  std::mt19937_64 random(seed);
  for (Index k = 0; k < 2 * n; ++k) points.uv.push_back(static_cast<double>(random() >> 11) * 0x1p-53);
  points.values.assign(static_cast<std::size_t>(n * dimension), 0.0);
  return points;
}

}  // namespace knotfit::scenes
