#include "verify/net_coordinates.h"

#include <gtest/gtest.h>

#include <vector>
namespace knotfit::verify {
namespace {

TEST(NetCoordinate, GrowsFromZeroToItsShareOfTheLargerCount) {
  const std::vector<double> knots = {0.28, 0.29, 0.3, 0.31, 0.5};
  const NetCoordinate xi(knots, net_scale(9));
  EXPECT_EQ(xi(0), 0);
  EXPECT_NEAR(xi(1), 8.0 / 12, 1e-15);
  double before = -1;
  for (int i = 0; i <= 1000; ++i) {
    EXPECT_GT(xi(i / 1000.0), before);
    before = xi(i / 1000.0);
  }
  // Close knots stretch: a step of 0.01 there is wider than one far from them.
  EXPECT_GT(xi(0.3) - xi(0.29), 5 * (xi(0.9) - xi(0.89)));
}

TEST(NetCoordinate, WithoutKnotsIsTheParameter) {
  const NetCoordinate xi({}, net_scale(0));
  for (double u : {0.0, 0.1, 0.5, 0.77, 1.0}) EXPECT_NEAR(xi(u), u, 1e-15);
}

}  // namespace
}  // namespace knotfit::verify
