#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/place.h"
#include "place/shares.h"
#include "place/trials.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(DerivativeShare, FollowsTheDerivativeOfTheOrder) {
  // |d^4 exp(a u)| ~ exp(a u), its fourth root ~ exp(a u / 4): shares are known.
  const double a = 8;
  const ParameterizedPoints points = grid_of(401, 5, [&](double u, double) { return std::exp(a * u); });
  PlacementOptions options;
  options.interior_v = 0;
  options.degree_v = 1;
  const std::vector<double> knots = place_knots("derivative-share", points, options).knots.u;
  for (int i = 0; i < 8; ++i)
    EXPECT_NEAR(knots[i], 4 / a * std::log(1 + (i + 1) / 9.0 * (std::exp(a / 4) - 1)), 0.01) << i;
}

TEST(DerivativeShare, IsUniformWhereTheDerivativeOfTheOrderIsConstant) {
  // d^4 u^4 = 24 everywhere. Divided differences of fourth order over lines 1/60 apart lose 2^4 kEps 60^4 / 24 of it.
  const ParameterizedPoints points =
      grid_of(61, 5, [](double u, double v) { return (1 + v) * u * u * u * u; });
  PlacementOptions options;
  options.interior_v = 0;
  options.degree_v = 1;
  const std::vector<double> knots = place_knots("derivative-share", points, options).knots.u;
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(knots[i], (i + 1) / 9.0, 1e-8) << i;
}

TEST(DerivativeShare, IsUniformWhereTheDataIsAPolynomial) {
  const ParameterizedPoints points = grid_of(30, 30, [](double, double) { return 1.0; });
  EXPECT_EQ(place_knots("derivative-share", points).knots.u, uniform_knots(8));
}

}  // namespace
}  // namespace knotfit::test
