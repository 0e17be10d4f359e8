#include "search/minimax.h"

#include <gtest/gtest.h>

#include "place/shares.h"
#include "search/searches.h"
#include "support/plain_fits.h"
namespace knotfit::test {
namespace {

TEST(Minimax, LowersTheMaximumOfTheLeastSquares) {
  const ParameterizedPoints points = synthetic_points("franke", 5000);
  MovingFit problem(points, 3, 3, plain_fits());
  const InteriorKnots knots{uniform_knots(7), uniform_knots(7)};
  problem.solve(knots);
  const double before = problem.max();
  MinimaxOptions fixed;
  fixed.move_knots = false;
  const NetState state = minimize_maximum(problem, {}, fixed);
  EXPECT_EQ(state.knots, knots);
  EXPECT_LT(state.max, 0.85 * before);
  problem.evaluate(state.knots, state.net);
  EXPECT_NEAR(problem.max(), state.max, 1e-12);
  problem.solve(knots);
  EXPECT_LT(minimize_maximum(problem, {}, {}).max, state.max);  // the knots move too
}

TEST(Minimax, EndsAtWhatIsEnough) {
  const ParameterizedPoints points = synthetic_points("franke", 3000);
  LeastSquaresOptions fit;
  fit.use_grid = false;
  MovingFit problem(points, 3, 3, fit);
  problem.solve({uniform_knots(6), uniform_knots(6)});
  MinimaxOptions options;
  options.enough = 2 * problem.max();
  const long fits = problem.fits();
  EXPECT_LE(minimize_maximum(problem, {}, options).max, options.enough);
  EXPECT_LE(problem.fits() - fits, 2);
}

}  // namespace
}  // namespace knotfit::test
