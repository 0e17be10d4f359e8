#include "place/full_lspia.h"

#include <gtest/gtest.h>

#include "knotfit/fit_least_squares.h"
#include "knotfit/place.h"
#include "place/shares.h"
#include "place/trials.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

FitProblem plain_problem(const ParameterizedPoints& points) {
  LeastSquaresOptions options;
  options.refinement_steps = 0;
  options.estimate_condition = false;
  options.use_grid = false;
  return FitProblem(points, 3, 3, options);
}

TEST(FullLspia, ErrorFallsEachRound) {
  for (const char* name : {"franke", "ridge", "torus"}) {
    const ParameterizedPoints points = synthetic_points(name, 3000);
    FitProblem problem = plain_problem(points);
    InteriorKnots knots{uniform_knots(8), uniform_knots(8)};
    FullLspiaOptions options;
    options.rounds = 15;
    const std::vector<double> history = full_lspia(problem, knots, options);
    ASSERT_GE(history.size(), 5u) << name;
    for (std::size_t i = 1; i < history.size(); ++i)
      EXPECT_LE(history[i], history[i - 1]) << name << " round " << i;
    EXPECT_LT(history.back(), history.front()) << name;
    // The last phi belongs to control points that are not yet the least squares' of the last knots.
    ASSERT_TRUE(problem.solve(knots));
    EXPECT_LE(problem.phi(), history.back() * (1 + 1e-6)) << name;
  }
}

TEST(FullLspia, BeatsItsStart) {
  const ParameterizedPoints points = synthetic_points("peaks", 4000);
  EXPECT_LT(rms(points, place_knots("full-lspia", points).knots),
            rms(points, place_knots("averaging", points).knots));
}

}  // namespace
}  // namespace knotfit::test
