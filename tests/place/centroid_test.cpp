#include <gtest/gtest.h>

#include "knotfit/place.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(Centroid, IsTheCentroidOfEachRegion) {
  PlacementOptions options;
  options.interior_u = 2;
  options.interior_v = 3;
  options.user_features = FeatureMap{4, 1, {3, 1, 1, 1}};
  const InteriorKnots knots = place_knots("centroid", synthetic_points("franke", 200), options).knots;
  // Half of the mass lies in the first cell, the other half evenly over the rest.
  EXPECT_NEAR(knots.u[0], 0.125, 1e-12);
  EXPECT_NEAR(knots.u[1], 0.625, 1e-12);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(knots.v[i], (2 * i + 1) / 6.0, 1e-12);
}

}  // namespace
}  // namespace knotfit::test
