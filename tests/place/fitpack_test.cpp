#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "knotfit/fit_least_squares.h"
#include "knotfit/place.h"
#include "place/shares.h"
#include "place/trials.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(Fitpack, PutsEachKnotAtTheMeanOfTheResiduals) {
  // The first knot: residuals of the cubic alone.
  const ParameterizedPoints points = synthetic_points("ridge", 3000);
  PlacementOptions options;
  options.interior_u = 1;
  options.interior_v = 0;
  const Placement placement = place_knots("fitpack", points, options);
  EXPECT_EQ(placement.fits, 1);
  LeastSquaresOptions plain;
  plain.refinement_steps = 0;
  const LeastSquaresResult cubic =
      fit_least_squares(points, KnotVector::uniform(3, 0), KnotVector::uniform(3, 0), plain);
  double squares = 0, moment = 0;
  for (Index k = 0; k < points.size(); ++k) {
    squares += square(cubic.errors[k]);
    moment += square(cubic.errors[k]) * points.u(k);
  }
  ASSERT_EQ(placement.knots.u.size(), 1u);
  EXPECT_NEAR(placement.knots.u[0], moment / squares, 1e-9);
}

TEST(Fitpack, SplitsTheSpanOfTheLargestResidualSum) {
  // Every knot is a knot of what came before, and stands in the span that the fit without it fits worst.
  const ParameterizedPoints points = synthetic_points("ridge", 3000);
  PlacementOptions options;
  options.interior_v = 0;
  options.interior_u = 1;
  std::vector<double> before = place_knots("fitpack", points, options).knots.u;
  for (int count = 2; count <= 6; ++count) {
    options.interior_u = count;
    const std::vector<double> after = place_knots("fitpack", points, options).knots.u;
    std::vector<double> added;
    std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(added));
    ASSERT_EQ(added.size(), 1u) << count;
    const LeastSquaresResult fit =
        fit_least_squares(points, KnotVector::clamped(3, before), KnotVector::uniform(3, 0));
    const std::vector<double> breaks = with_ends(before);
    std::vector<double> squares(breaks.size() - 1, 0.0);
    for (Index k = 0; k < points.size(); ++k)
      for (std::size_t s = 0; s < squares.size(); ++s)
        if (points.u(k) >= breaks[s] && points.u(k) < breaks[s + 1]) squares[s] += square(fit.errors[k]);
    const auto worst = std::max_element(squares.begin(), squares.end()) - squares.begin();
    EXPECT_GT(added[0], breaks[worst]) << count;
    EXPECT_LT(added[0], breaks[worst + 1]) << count;
    before = after;
  }
}

TEST(Fitpack, GoesWhereTheErrorIs) {
  const ParameterizedPoints points =
      grid_of(201, 21, [](double u, double) { return std::tanh(60 * (u - 0.3)); });
  const Placement placement = place_knots("fitpack", points);
  EXPECT_GE(inside(placement.knots.u, 0.2, 0.4), 4);
  EXPECT_EQ(placement.fits, 16);
}

}  // namespace
}  // namespace knotfit::test
