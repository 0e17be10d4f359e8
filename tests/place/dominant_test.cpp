#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/place.h"
#include "place/trials.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(Dominant, ColumnsGatherWhereAGridBends) {
  // A bend at u = 0.3 of every row; along v nothing happens.
  const ParameterizedPoints points =
      grid_of(101, 41, [](double u, double) { return std::tanh(60 * (u - 0.3)); });
  const InteriorKnots knots = place_knots("dominant", points).knots;
  EXPECT_GE(inside(knots.u, 0.2, 0.4), 6) << "of 8, in a fifth of the domain";
  EXPECT_LE(inside(knots.v, 0.2, 0.4), 3);
  EXPECT_LT(rms(points, knots), 0.2 * rms(points, place_knots("uniform", points).knots));
}

TEST(Dominant, TakesOneFitALine) {
  const ParameterizedPoints points = grid_of(61, 61, franke);
  PlacementOptions options;
  options.interior_u = 12;
  options.interior_v = 9;
  const Placement placement = place_knots("dominant", points, options);
  // It starts from 4 to 7 lines of each direction's 16 and 13.
  EXPECT_GE(placement.fits, 16 + 13 - 2 * 7);
  EXPECT_LE(placement.fits, 16 + 13 - 2 * 4);
}

}  // namespace
}  // namespace knotfit::test
