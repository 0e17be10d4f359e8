#include <gtest/gtest.h>

#include "knotfit/place.h"
#include "place/shares.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(EqualShare, CutsTheMarginalsEvenly) {
  PlacementOptions options;
  options.interior_u = 3;
  options.interior_v = 1;
  options.user_features = FeatureMap{4, 2, {1, 1, 2, 2, 3, 3, 2, 2}};
  const Placement placement = place_knots("equal-share", synthetic_points("franke", 200), options);
  // Marginal of u: 1/8, 2/8, 3/8, 2/8 of the whole.
  EXPECT_NEAR(placement.knots.u[0], 0.25 + 0.25 / 2, 1e-12);
  EXPECT_NEAR(placement.knots.u[1], 0.5 + 0.25 / 3, 1e-12);
  EXPECT_NEAR(placement.knots.u[2], 0.75, 1e-12);
  EXPECT_NEAR(placement.knots.v[0], 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(placement.criterion, cell_criterion(options.user_features, placement.knots));
}

}  // namespace
}  // namespace knotfit::test
