#include "fit/moving_fit.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "support/synthetic.h"
namespace knotfit::test {
namespace {

ParameterizedPoints grid_of(int side) {
  ParameterizedPoints points;
  points.dimension = 1;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double u = i / (side - 1.0), v = j / (side - 1.0);
      points.uv.insert(points.uv.end(), {u, v});
      points.values.push_back(std::sin(5 * u) * std::cos(3 * v) + 0.1 * ((i * 7 + j * 3) % 5));
    }
  return points;
}

// A fit keeps a reference to its points: none can be made of points that end with the line.
static_assert(!std::is_constructible_v<MovingFit, ParameterizedPoints, int, int>);
static_assert(!std::is_constructible_v<FitProblem, ParameterizedPoints, int, int>);
static_assert(std::is_constructible_v<MovingFit, ParameterizedPoints&, int, int>);

TEST(MovingFit, TakesAGridAsScatteredPoints) {
  const ParameterizedPoints points = grid_of(12);
  const InteriorKnots knots{{0.4}, {0.3, 0.7}};
  MovingFit moving(points, 3, 3);
  FitProblem grid(points, 3, 3);
  EXPECT_FALSE(moving.on_grid());
  ASSERT_TRUE(grid.on_grid());
  ASSERT_TRUE(moving.solve(knots));
  ASSERT_TRUE(grid.solve(knots));
  EXPECT_NEAR(moving.rms(), grid.rms(), 1e-9 * grid.rms());
  EXPECT_EQ(moving.jacobian().knots, 3u);
}

TEST(MovingFit, CountsTheFirstPointsAlone) {
  ParameterizedPoints points = grid_of(10);
  const Index own = points.size();
  MovingFit fit(points, 2, 2);
  points.uv.insert(points.uv.end(), {0.5, 0.5});
  points.values.push_back(1e3);
  fit.take_new_points();
  fit.count_first(own);
  ASSERT_TRUE(fit.solve({{0.5}, {0.5}}));
  EXPECT_EQ(static_cast<Index>(fit.errors().size()), own);
  const std::vector<double>& r = fit.residual();
  double all = 0;
  for (const double x : r) all = std::max(all, std::abs(x));
  EXPECT_LT(fit.max(), all);  // the point that joined is farthest, and does not count
}

TEST(MovingFit, RestoresANetWithItsResiduals) {
  const ParameterizedPoints points = grid_of(10);
  MovingFit fit(points, 3, 3);
  ASSERT_TRUE(fit.solve({{0.5}, {0.5}}));
  const std::vector<double> net = fit.net(), residual = fit.residual();
  const double rms = fit.rms(), max = fit.max();
  std::vector<double> other = net;
  for (double& x : other) x += 1;
  fit.evaluate(fit.knots(), other);
  EXPECT_NEAR(fit.residual()[0], residual[0] + 1, 1e-12);
  fit.restore(net, residual);
  EXPECT_EQ(fit.net(), net);
  EXPECT_NEAR(fit.rms(), rms, 1e-15);
  EXPECT_EQ(fit.max(), max);
}

TEST(FitProblem, EvaluatesANetOnAGridToo) {
  const ParameterizedPoints points = grid_of(12);
  const InteriorKnots knots{{0.4}, {0.3, 0.7}};
  FitProblem grid(points, 3, 3);
  MovingFit moving(points, 3, 3);
  ASSERT_TRUE(moving.solve(knots));
  grid.evaluate(knots, moving.net());
  EXPECT_NEAR(grid.max(), moving.max(), 1e-12);
  EXPECT_NEAR(grid.rms(), moving.rms(), 1e-12);
}

}  // namespace
}  // namespace knotfit::test
