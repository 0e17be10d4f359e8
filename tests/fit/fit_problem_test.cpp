#include "fit/fit_problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
#include "support/dense_reference.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

TEST(FitProblem, FitsTheSamePointsOnOtherKnots) {
  Random random;
  const ParameterizedPoints points = random_points(random, 2000, 2);
  FitProblem again(points, 3, 2);
  for (int size : {3, 8, 5}) {
    const InteriorKnots knots{random_interior(random, size), random_interior(random, 8 - size)};
    ASSERT_TRUE(again.solve(knots));
    EXPECT_EQ(again.knots(), knots);
    EXPECT_EQ(again.control_points(), (size + 4) * (8 - size + 3));
    FitProblem fresh(points, 3, 2);
    ASSERT_TRUE(fresh.solve(knots));
    EXPECT_EQ(again.net(), fresh.net());
    EXPECT_EQ(again.errors(), fresh.errors());
    EXPECT_EQ(again.surface().net(), again.net());
  }
  EXPECT_EQ(again.fits(), 3);
}

TEST(FitProblem, MeasuresTheErrorAskedFor) {
  Random random;
  const ParameterizedPoints points = random_points(random, 500, 3, true);
  FitProblem problem(points, 3, 3);
  ASSERT_TRUE(problem.solve({{0.5}, {0.5}}));
  const std::vector<double> errors = problem.errors();
  EXPECT_NEAR(problem.rms(), measured_error(errors, {1, ErrorMeasure::rms}), 500 * kEps);
  EXPECT_EQ(problem.max(), measured_error(errors, {1, ErrorMeasure::max}));
  EXPECT_EQ(problem.measured({1, ErrorMeasure::rms}), problem.rms());
  EXPECT_EQ(problem.measured({1, ErrorMeasure::max}), problem.max());
  EXPECT_EQ(problem.measured({1, ErrorMeasure::percentile, 0.9}), error_quantile(errors, 0.9));
}

TEST(FitProblem, KnowsWhatAGridCanTellApart) {
  Random random;
  ParameterizedPoints points;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 11; ++j) {
      points.uv.insert(points.uv.end(), {i / 6.0, j / 10.0});
      points.values.push_back(random.unit());
    }
  const FitProblem grid(points, 3, 3);
  EXPECT_TRUE(grid.on_grid());
  EXPECT_EQ(grid.most_functions_u(), 7);
  EXPECT_EQ(grid.most_functions_v(), 11);
  LeastSquaresOptions scattered;
  scattered.use_grid = false;
  const FitProblem plain(points, 3, 3, scattered);
  EXPECT_FALSE(plain.on_grid());
  EXPECT_EQ(plain.most_functions_u(), 77);
  points.weights.assign(77, 1.0);
  EXPECT_FALSE(FitProblem(points, 3, 3).on_grid());  // weights of their own are not separable
}

TEST(FitProblem, RefusesBadInput) {
  Random random;
  ParameterizedPoints points = random_points(random, 50, 1);
  expect_throw<InvalidInput>([&] { FitProblem(points, 0, 3); }, "degree 0 is outside [1, 9]");
  expect_throw<InvalidInput>([&] { FitProblem(points, 3, 10); }, "degree 10 is outside [1, 9]");
  for (double bad :
       {-1e-9, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    LeastSquaresOptions options;
    options.smoothing = bad;
    expect_throw<InvalidInput>([&] { FitProblem(points, 3, 3, options); },
                               "the smoothing floor must be finite and at least 0");
  }
  FitProblem problem(points, 3, 3);
  expect_throw<InvalidInput>([&] { problem.solve({{1.0}, {}}); }, "interior knot 0 (1) is not inside (0, 1)");
  expect_throw<InvalidInput>([&] { problem.solve({{}, {0.5, 0.25}}); }, "sort the knots");
  points.values[7] = INFINITY;
  expect_throw<InvalidInput>([&] { FitProblem(points, 3, 3); }, "point 7 has a value that is not finite");
}

TEST(FitProblem, OperationsGrowWithPointsAndFunctions) {
  Random random;
  const ParameterizedPoints few = random_points(random, 100, 1), many = random_points(random, 1000, 1);
  const FitProblem a(few, 3, 3), b(many, 3, 3);
  EXPECT_GT(a.operations(10, 10), 0);
  EXPECT_GT(a.operations(20, 10), a.operations(10, 10));
  EXPECT_GT(b.operations(10, 10), a.operations(10, 10));
  EXPECT_EQ(a.operations(10, 20), a.operations(20, 10));  // the band runs along the longer direction
}

TEST(FittedGrid, IsThatOfThePointsAndNoneWhereTheyHaveWeights) {
  ParameterizedPoints points;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 5; ++j) {
      points.uv.insert(points.uv.end(), {i / 5.0, j / 4.0});
      points.values.push_back(i * j);
    }
  EXPECT_EQ(fitted_grid(points).u.size(), 6u);
  EXPECT_TRUE(FitProblem(points, 3, 3).on_grid());
  points.weights.assign(30, 1);
  EXPECT_TRUE(fitted_grid(points).empty());
  EXPECT_FALSE(FitProblem(points, 3, 3).on_grid());
}

}  // namespace
}  // namespace knotfit::test
