#include <gtest/gtest.h>

#include <algorithm>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/fit_least_squares.h"
#include "knotfit/place.h"
#include "place/shares.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(Prune, KeepsTheToleranceAndLosesKnots) {
  const ParameterizedPoints points = synthetic_points("franke", 3000);
  const InteriorKnots dense{uniform_knots(9), uniform_knots(9)};
  for (const ErrorMeasure measure : {ErrorMeasure::max, ErrorMeasure::rms}) {
    const Tolerance tolerance{measure == ErrorMeasure::max ? 0.02 : 0.003, measure, 1};
    const Placement pruned = prune_knots(points, dense, tolerance);
    EXPECT_LT(pruned.knots.u.size() + pruned.knots.v.size(), 16u);
    const LeastSquaresResult fit = fit_least_squares(points, KnotVector::clamped(3, pruned.knots.u),
                                                     KnotVector::clamped(3, pruned.knots.v));
    EXPECT_LE(measured_error(fit.errors, tolerance), tolerance.value * (1 + 1e-5));
    EXPECT_EQ(pruned.status, PlacementStatus::converged);
    // What is left is a part of what was given.
    EXPECT_TRUE(std::includes(dense.u.begin(), dense.u.end(), pruned.knots.u.begin(), pruned.knots.u.end()));
    EXPECT_TRUE(std::includes(dense.v.begin(), dense.v.end(), pruned.knots.v.begin(), pruned.knots.v.end()));
  }
}

TEST(Prune, LeavesKnotsThatDoNotHoldTheTolerance) {
  const ParameterizedPoints points = synthetic_points("ridge", 2000);
  const InteriorKnots given{uniform_knots(4), uniform_knots(4)};
  const Placement pruned = prune_knots(points, given, {1e-6, ErrorMeasure::max, 1});
  EXPECT_EQ(pruned.knots, given);
  EXPECT_EQ(pruned.status, PlacementStatus::limit);
  ASSERT_EQ(pruned.notes.size(), 1u);
  EXPECT_NE(pruned.notes[0].find("do not hold the tolerance"), std::string::npos);
  expect_throw<InvalidInput>(
      [&] {
        prune_knots(points, given, {0, ErrorMeasure::max, 1});
      },
      "must be positive");
}

TEST(Prune, FindsTheKnotsThatASplineHas) {
  // Ten knots a direction, of which the spline has three.
  Random random(3);
  const std::vector<double> own{0.3, 0.5, 0.8};
  const KnotVector knots = KnotVector::clamped(3, own);
  const Surface s(knots, knots, 1, random_numbers(random, 49));
  ParameterizedPoints points;
  Uniform uniform(5);
  for (int k = 0; k < 2000; ++k) points.uv.insert(points.uv.end(), {uniform(), uniform()});
  points.values = evaluate(s, points.uv);
  const std::vector<double> many{0.1, 0.2, 0.3, 0.4, 0.45, 0.5, 0.6, 0.7, 0.8, 0.9};
  const Placement pruned = prune_knots(points, {many, many}, {1e-6, ErrorMeasure::max, 1});
  EXPECT_EQ(pruned.knots, (InteriorKnots{own, own}));
}

}  // namespace
}  // namespace knotfit::test
