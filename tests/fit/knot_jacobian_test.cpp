#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fit/moving_fit.h"
#include "solve/banded_system.h"
#include "support/plain_fits.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

constexpr double kStep = 1e-5;

/// Points of a synthetic set cut to `dimension` components, with weights and a hole smaller than a cell.
ParameterizedPoints sample(int dimension) {
  ParameterizedPoints all = synthetic_points("torus", 3000), points;
  points.dimension = dimension;
  Uniform uniform(7);
  for (Index k = 0; k < all.size(); ++k) {
    if (std::hypot(all.u(k) - 0.4, all.v(k) - 0.45) < 0.03) continue;
    points.uv.insert(points.uv.end(), {all.u(k), all.v(k)});
    points.values.insert(points.values.end(), all.value(k), all.value(k) + dimension);
    points.weights.push_back(0.5 + uniform());
  }
  return points;
}

/// The knots with every copy of knot l (u first, then v) moved by h.
InteriorKnots moved(InteriorKnots knots, std::size_t l, double h) {
  std::vector<double>& line = l < knots.u.size() ? knots.u : knots.v;
  const double old = line[l < knots.u.size() ? l : l - knots.u.size()];
  for (double& x : line)
    if (x == old) x += h;
  return knots;
}

class KnotJacobianOf : public testing::TestWithParam<std::tuple<int, int, int>> {};

TEST_P(KnotJacobianOf, AgreesWithDifferences) {
  const auto [degree_u, degree_v, dimension] = GetParam();
  const ParameterizedPoints points = sample(dimension);
  MovingFit problem(points, degree_u, degree_v, plain_fits(0));
  const InteriorKnots knots{{0.17, 0.31, 0.52, 0.7, 0.83}, {0.1, 0.4, 0.55, 0.75}};
  ASSERT_TRUE(problem.solve(knots));
  const KnotJacobian full = problem.jacobian(true);
  const std::size_t n = 9;
  ASSERT_EQ(full.knots, n);

  const std::vector<double> weights = problem.order().weights();
  std::vector<std::vector<double>> columns;
  double largest = 0;
  for (double g : full.gradient) largest = std::max(largest, std::abs(2 * g));
  for (std::size_t l = 0; l < n; ++l) {
    ASSERT_TRUE(problem.solve(moved(knots, l, kStep)));
    const double after = problem.phi();
    std::vector<double> column = problem.residual();
    ASSERT_TRUE(problem.solve(moved(knots, l, -kStep)));
    EXPECT_NEAR(2 * full.gradient[l], (after - problem.phi()) / (2 * kStep), 1e-7 * largest) << "knot " << l;
    const std::vector<double>& before = problem.residual();
    for (std::size_t i = 0; i < column.size(); ++i) column[i] = (column[i] - before[i]) / (2 * kStep);
    columns.push_back(std::move(column));
  }
  double scale = 0, worst = 0;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) {
      double sum = 0;
      for (std::size_t i = 0; i < columns[a].size(); ++i)
        sum += weights[i / dimension] * columns[a][i] * columns[b][i];
      scale = std::max(scale, std::abs(sum));
      worst = std::max(worst, std::abs(sum - full.matrix[a * n + b]));
    }
  EXPECT_LE(worst, 1e-7 * scale);
}

INSTANTIATE_TEST_SUITE_P(DegreesAndDimensions, KnotJacobianOf,
                         testing::Values(std::tuple{1, 3, 1}, std::tuple{2, 2, 2}, std::tuple{3, 3, 1},
                                         std::tuple{3, 5, 3}, std::tuple{4, 1, 2}, std::tuple{5, 4, 3}));

TEST(KnotJacobian, CopiesOfAMultipleKnotSumToItsDerivative) {
  const ParameterizedPoints points = sample(3);
  MovingFit problem(points, 3, 4, plain_fits(0));
  const InteriorKnots knots{{0.17, 0.31, 0.31, 0.7}, {0.4, 0.4, 0.4, 0.75}};
  ASSERT_TRUE(problem.solve(knots));
  const KnotJacobian j = problem.jacobian();
  const std::vector<std::pair<std::size_t, std::vector<std::size_t>>> groups{
      {0, {0}}, {1, {1, 2}}, {3, {3}}, {4, {4, 5, 6}}, {7, {7}}};
  double largest = 0;
  for (double g : j.gradient) largest = std::max(largest, std::abs(2 * g));
  for (const auto& [knot, copies] : groups) {
    double derivative = 0;
    for (std::size_t c : copies) derivative += 2 * j.gradient[c];
    problem.solve(moved(knots, knot, kStep));
    const double after = problem.phi();
    problem.solve(moved(knots, knot, -kStep));
    EXPECT_NEAR(derivative, (after - problem.phi()) / (2 * kStep), 1e-7 * largest) << "knot " << knot;
  }
}

TEST(KnotJacobian, KaufmansLacksOnlyAPositiveTerm) {
  const ParameterizedPoints points = sample(2);
  MovingFit problem(points, 3, 3, plain_fits(0));
  problem.solve({{0.2, 0.5, 0.8}, {0.3, 0.6}});
  const KnotJacobian kaufman = problem.jacobian(false);
  const KnotJacobian full = problem.jacobian(true);
  EXPECT_EQ(kaufman.gradient, full.gradient);
  for (std::size_t i = 0; i < full.knots; ++i)
    EXPECT_GE(full.matrix[i * full.knots + i], kaufman.matrix[i * full.knots + i]);
}

}  // namespace
}  // namespace knotfit::test
