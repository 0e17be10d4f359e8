#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "knotfit/place.h"
namespace knotfit::test {
namespace {

TEST(Sparse, FindsTheJumpsOfASpline) {
  // Rows of a cubic spline with knots at 0.25, 0.4, 0.7 and large jumps.
  const std::vector<double> own{0.25, 0.4, 0.7};
  ParameterizedPoints points;
  points.height_field = true;
  for (int i = 0; i <= 120; ++i)
    for (int j = 0; j <= 10; ++j) {
      const double u = i / 120.0, v = j / 10.0;
      double z = u * (1 + v);
      for (std::size_t k = 0; k < own.size(); ++k)
        z += (k % 2 ? -30.0 : 20.0) * (1 + 0.5 * v) * std::pow(std::max(0.0, u - own[k]), 3);
      points.uv.insert(points.uv.end(), {u, v});
      points.values.push_back(z);
    }
  PlacementOptions options;
  options.interior_u = 3;
  options.interior_v = 0;
  options.degree_v = 2;
  const Placement placement = place_knots("sparse", points, options);
  // The dense knots stand 1/61 apart.
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(placement.knots.u[k], own[k], 1.5 / 61) << k;
}

}  // namespace
}  // namespace knotfit::test
