#include "search/guard.h"

#include <gtest/gtest.h>

#include <cmath>

#include "place/shares.h"
#include "search/searches.h"
#include "support/plain_fits.h"
namespace knotfit::test {
namespace {

/// A guard of points on Franke's function, and a problem over what joins them.
struct Guarded {
  ParameterizedPoints points = synthetic_points("franke", 4000);
  double tolerance = 1e-3 * synthetic_diagonal(points);
  JoinedPoints joined{points};
  Guard guard{joined, tolerance, 1, {uniform_knots(12), uniform_knots(12)}, {}};
  MovingFit problem{joined.points(), 3, 3, plain_fits()};
};

TEST(Guard, FillsTheGapsThatAreWideForTheKnots) {
  Guarded guarded;
  auto& [points, tolerance, joined, guard, problem] = guarded;
  EXPECT_EQ(joined.data_count(), points.size());
  EXPECT_EQ(guard.fill_count(), 0);
  problem.solve({uniform_knots(2), uniform_knots(2)});
  EXPECT_EQ(guard.fill(problem), 0);  // 440 points a cell: nowhere to go astray
  problem.solve({uniform_knots(24), uniform_knots(24)});
  const Index filled = guard.fill(problem);
  EXPECT_GT(filled, 200);
  EXPECT_EQ(guard.fill_count(), filled);
  EXPECT_EQ(joined.points().size(), points.size() + filled);
  problem.take_new_points();
  problem.solve({uniform_knots(24), uniform_knots(24)});
  EXPECT_EQ(guard.fill(problem), 0);  // they joined for good
  for (Index k = points.size(); k < joined.points().size(); ++k) {
    const double truth = franke(joined.points().u(k), joined.points().v(k));
    EXPECT_NEAR(joined.points().value(k)[0], truth, 4 * tolerance);
  }
}

TEST(Guard, TakesInWhereASurfaceGoesAstray) {
  Guarded guarded;
  auto& [points, tolerance, joined, guard, problem] = guarded;
  const InteriorKnots knots{uniform_knots(24), uniform_knots(24)};
  problem.solve(knots);
  EXPECT_LE(guard.exchange(problem), 5);  // a fair fit is near the reference at most of 1 000 places
  std::vector<double> net = problem.net();
  for (double& c : net) c += 10 * tolerance;
  problem.take_new_points();
  problem.evaluate(knots, net);
  EXPECT_GT(guard.exchange(problem), 200);
}

TEST(Guard, LooksIntoASlitBetweenTwoKnots) {
  Guarded guarded;
  auto& [points, tolerance, joined, guard, problem] = guarded;
  const InteriorKnots knots{{0.4999, 0.4999, 0.5, 0.5001, 0.5001}, {}};
  problem.solve(knots);
  std::vector<double> net = problem.net();
  const Index columns = problem.axis_v().functions();
  for (Index j = 0; j < columns; ++j) net[4 * columns + j] += 1e3 * tolerance;  // inside of the slit alone
  problem.evaluate(knots, net);
  guard.exchange(problem);
  bool inside = false;
  for (Index k = points.size(); k < joined.points().size(); ++k)
    inside |= std::abs(joined.points().u(k) - 0.5) < 1e-4;
  EXPECT_TRUE(inside);
}

}  // namespace
}  // namespace knotfit::test
