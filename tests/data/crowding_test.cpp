#include "data/crowding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_splines.h"
namespace knotfit {
namespace {

using namespace knotfit::test;

/// A plane of width 2, of which parameters below `share` hold the half x < 1.
ParameterizedPoints plane(double share) {
  Random random(5);
  ParameterizedPoints points;
  points.dimension = 3;
  for (int k = 0; k < 4000; ++k) {
    const double x = random.uniform(0, 2), y = random.unit();
    points.uv.insert(points.uv.end(), {x < 1 ? share * x : share + (1 - share) * (x - 1), y});
    points.values.insert(points.values.end(), {x, y, 0.0});
  }
  return points;
}

TEST(Crowding, EvenParametersCrowdNothing) {
  EXPECT_LT(crowded_share(IndexedPoints(plane(0.5))), 0.001);
}

TEST(Crowding, IsSeenWhereParametersSqueezeAPart) {
  // A tenth of the surface shrunk to a point in both parameters, at even points in space.
  ParameterizedPoints points = plane(0.5);
  for (Index k = 0; k < points.size(); ++k) {
    double* uv = points.uv.data() + 2 * k;
    const double r = std::hypot(uv[0] - 0.5, uv[1] - 0.5);
    if (r > 0.2) continue;
    for (int d = 0; d < 2; ++d) uv[d] = 0.5 + 0.05 * (uv[d] - 0.5);
  }
  EXPECT_GT(crowded_share(IndexedPoints(points)), kCrowded);
}

// Points that are near in space too are a cluster of the data, not of its parameters.
TEST(Crowding, ClustersOfTheDataAreNone) {
  ParameterizedPoints points = plane(0.5);
  for (Index k = 0; k < points.size() / 10; ++k)
    for (int d = 0; d < 2; ++d) {
      points.uv[2 * k + d] = 0.5 + 0.01 * (points.uv[2 * k + d] - 0.5);
      points.values[3 * k + d] = 0.01 * points.values[3 * k + d];
    }
  EXPECT_LT(crowded_share(IndexedPoints(points)), 0.001);
}

}  // namespace
}  // namespace knotfit
