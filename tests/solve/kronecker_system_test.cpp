#include "solve/kronecker_system.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solve/banded_system.h"
#include "support/random_splines.h"
namespace knotfit {
namespace {

using namespace knotfit::test;

/// Values of any kind on an uneven grid of 12 x 9, the points in an order of their own.
ParameterizedPoints grid_points(Random& random) {
  ParameterizedPoints points;
  points.dimension = 2;
  for (int j = 0; j < 9; ++j)
    for (int i = 11; i >= 0; --i) {
      points.uv.insert(points.uv.end(), {std::pow(i / 11.0, 1.5), j / 8.0});
      for (int e = 0; e < 2; ++e) points.values.push_back(random.uniform(-1, 1));
    }
  return points;
}

TEST(KroneckerSystem, SolvesWhatTheBandedSystemSolves) {
  Random random;
  const ParameterizedPoints points = grid_points(random);
  const Axis u(3, std::vector{0.3, 0.6}), v(2, std::vector{0.5});
  KroneckerSystem grid(points, find_grid(points));
  BandedSystem scattered(points);
  ASSERT_TRUE(grid.factor(u, v, 0));
  ASSERT_TRUE(scattered.factor(u, v, 0));
  const std::vector<double> net = grid.project_data(), expected = scattered.project_data();
  ASSERT_EQ(net.size(), expected.size());
  for (std::size_t k = 0; k < net.size(); ++k) EXPECT_NEAR(net[k], expected[k], 1e-11) << k;

  const ResidualSums a = grid.residuals(net), b = scattered.residuals(net);
  EXPECT_NEAR(a.squares, b.squares, 1e-12);
  EXPECT_NEAR(a.weighted, b.weighted, 1e-12);
  EXPECT_NEAR(a.max, b.max, 1e-12);
  const std::vector<double> errors = grid.errors(), in_input_order = scattered.errors();
  for (std::size_t k = 0; k < errors.size(); ++k) EXPECT_NEAR(errors[k], in_input_order[k], 1e-12) << k;
}

TEST(KroneckerSystem, LeastSquaresLeaveNothingToProject) {
  Random random;
  const ParameterizedPoints points = grid_points(random);
  const Axis u(3, std::vector{0.4}), v(3);
  KroneckerSystem system(points, find_grid(points));
  ASSERT_TRUE(system.factor(u, v, 0));
  system.residuals(system.project_data());
  for (const double x : system.project_residual()) EXPECT_NEAR(x, 0, 1e-12);
}

TEST(KroneckerSystem, CountsCellsWithoutPointsAndRefusesToSolveThem) {
  Random random;
  const ParameterizedPoints points = grid_points(random);
  // Three spans of u lie between the lines 0 and 11^-1.5 = 0.027; v has a line in each of two.
  const Axis u(3, std::vector{0.005, 0.01, 0.015, 0.02}), v(1, std::vector{0.5});
  KroneckerSystem system(points, find_grid(points));
  EXPECT_FALSE(system.factor(u, v, 0));
  ASSERT_TRUE(system.factor(u, v, 1e-6)) << "smoothing holds what no point does";
  EXPECT_EQ(system.empty_cells(), 3 * 2);
  EXPECT_GT(system.smoothing(), 0);
}

}  // namespace
}  // namespace knotfit
