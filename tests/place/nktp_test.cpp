#include <gtest/gtest.h>

#include "knotfit/place.h"
#include "place/row_knots.h"
#include "place/trials.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(Nktp, OnUniformRowsIsUniformAndSparserAtTheEnds) {
  std::vector<double> t(401);
  for (int i = 0; i <= 400; ++i) t[i] = i / 400.0;
  const std::vector<double> knots = nktp_knots(t, 15, 3);
  ASSERT_EQ(knots.size(), 15u);
  // Groups of (N - 1)/(n - 2) parameters: their means step by that many lines, up to one line of rounding a group.
  const double step = 399.0 / 17 / 400;
  for (std::size_t i = 2; i + 2 < knots.size(); ++i)
    EXPECT_NEAR(knots[i + 1] - knots[i], step, 1.0 / 400) << i;
  // The end parameters stand alone: the first span is the mean of 1, 2, 3 groups less half a group.
  EXPECT_NEAR(knots.front(), 1.5 * step, 1.5 / 400);
  EXPECT_NEAR(1 - knots.back(), 1.5 * step, 1.5 / 400);
}

TEST(Nktp, IsBlindToShape) {
  const Placement flat = place_knots("nktp", grid_of(61, 41, [](double, double) { return 0.0; }));
  const Placement steep = place_knots("nktp", grid_of(61, 41, step));
  EXPECT_EQ(flat.knots, steep.knots);
  EXPECT_TRUE(steep.notes.empty()) << "its own grid: nothing to say";
}

TEST(Nktp, FollowsTheDensityOfTheRows) {
  std::vector<double> t;
  for (int i = 0; i <= 300; ++i) t.push_back(square(i / 300.0));
  const std::vector<double> knots = nktp_knots(t, 9, 3);
  EXPECT_GT(inside(knots, 0, 0.25), 3);  // half of the parameters lie below 1/4
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) EXPECT_LT(knots[i], knots[i + 1]);
}

TEST(Nktp, FewerRowsThanControlPointsStillGiveAPlacement) {
  PlacementOptions options;
  options.interior_u = 9;
  options.interior_v = 5;
  const Placement placement = place_knots("nktp", grid_of(6, 7, franke), options);
  EXPECT_EQ(placement.knots.u.size(), 9u);
  for (std::size_t i = 0; i + 1 < 9; ++i) EXPECT_LT(placement.knots.u[i], placement.knots.u[i + 1]);
}

}  // namespace
}  // namespace knotfit::test
