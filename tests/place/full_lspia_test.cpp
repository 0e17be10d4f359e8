#include "place/full_lspia.h"

#include <gtest/gtest.h>

#include "knotfit/fit_least_squares.h"
#include "knotfit/place.h"
#include "place/shares.h"
#include "place/trials.h"
#include "support/plain_fits.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(FullLspia, ErrorFallsEachRound) {
  for (const char* name : {"franke", "ridge", "torus"}) {
    const ParameterizedPoints points = synthetic_points(name, 3000);
    FitProblem problem(points, 3, 3, plain_fits());
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
