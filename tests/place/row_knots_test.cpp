#include "place/row_knots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "knotfit/interior_knots.h"
namespace knotfit {
namespace {

TEST(AveragedKnots, AreMeansOfDegreeValues) {
  const std::vector<double> r = {0, 0.1, 0.3, 0.4, 0.8, 1};
  EXPECT_EQ(averaged_knots(r, 1), (std::vector<double>{0.1, 0.3, 0.4, 0.8}));
  const std::vector<double> cubic = averaged_knots(r, 3);
  ASSERT_EQ(cubic.size(), 2u);
  EXPECT_NEAR(cubic[0], (0.1 + 0.3 + 0.4) / 3, 1e-15);
  EXPECT_NEAR(cubic[1], (0.3 + 0.4 + 0.8) / 3, 1e-15);
  EXPECT_TRUE(averaged_knots(std::vector<double>{0, 0.4, 0.6, 1}, 3).empty());
}

TEST(SettleKnots, HalvesTheLongestSpansUntilTheCountIsThere) {
  InteriorKnots knots{{0.8}, {}};
  settle_knots(knots, 3, 1);
  EXPECT_EQ(knots.u, (std::vector<double>{0.2, 0.4, 0.8}));
  EXPECT_EQ(knots.v, (std::vector<double>{0.5}));
}

TEST(SettleKnots, SortsAndLeavesTheFirstOfTooMany) {
  InteriorKnots knots{{0.6, 0.2, 0.4}, {}};
  settle_knots(knots, 2, 0);
  EXPECT_EQ(knots.u, (std::vector<double>{0.2, 0.4}));
  EXPECT_TRUE(knots.v.empty());
}

TEST(SettleKnots, PartsKnotsThatCoincide) {
  InteriorKnots knots{{0.5, 0.5, 0.5}, {}};
  settle_knots(knots, 3, 0);
  for (std::size_t i = 0; i + 1 < 3; ++i) EXPECT_GE(knots.u[i + 1] - knots.u[i], 0.01 / 4 * (1 - 1e-9));
}

}  // namespace
}  // namespace knotfit
