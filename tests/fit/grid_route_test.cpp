// Points that fill a grid are solved direction by direction: the same surface as by the scattered route.
#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/fit_least_squares.h"
#include "knotfit/threads.h"
#include "support/dense_reference.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

ParameterizedPoints random_grid(Random& random, int size_u, int size_v, int dimension) {
  ParameterizedPoints points;
  points.dimension = dimension;
  std::vector<double> u, v;
  for (int i = 0; i < size_u; ++i) u.push_back((i + random.uniform(0, 0.8)) / size_u);
  for (int j = 0; j < size_v; ++j) v.push_back((j + random.uniform(0, 0.8)) / size_v);
  u.back() = v.back() = 1;
  for (double a : u)
    for (double b : v) {
      points.uv.insert(points.uv.end(), {a, b});
      for (int d = 0; d < dimension; ++d) points.values.push_back(random.uniform(-1, 1));
    }
  return points;
}

LeastSquaresResult fit(const ParameterizedPoints& points, const KnotVector& u, const KnotVector& v,
                       bool grid) {
  LeastSquaresOptions options;
  options.use_grid = grid;
  LeastSquaresResult result = fit_least_squares(points, u, v, options);
  EXPECT_EQ(result.status, FitStatus::solved);
  EXPECT_EQ(result.on_grid, grid);
  return result;
}

TEST(GridRoute, GivesTheNetOfTheScatteredRoute) {
  Random random;
  for (const auto& [m, n] : {std::pair{3, 3}, {1, 1}, {2, 4}, {5, 3}})
    for (int dimension : {1, 3}) {
      const ParameterizedPoints points = random_grid(random, 40, 30, dimension);
      const KnotVector u = KnotVector::uniform(m, 6), v = KnotVector::uniform(n, 5);
      const LeastSquaresResult a = fit(points, u, v, true), b = fit(points, u, v, false);
      // Both reach the minimiser up to the square of the floor's share and rounding times condition.
      for (std::size_t k = 0; k < a.surface.net().size(); ++k)
        EXPECT_NEAR(a.surface.net()[k], b.surface.net()[k], 1e-9) << m << "x" << n;
      EXPECT_NEAR(a.error.rms, b.error.rms, 1e-12);
      EXPECT_EQ(a.error.worst, b.error.worst);
      EXPECT_EQ(a.empty_cells, b.empty_cells);
      // Both estimate a condition from below, to a factor of a few a direction.
      EXPECT_LT(std::abs(std::log10(a.condition / b.condition)), 1.5) << a.condition << " " << b.condition;
    }
}

TEST(GridRoute, CountsTheCellsWithoutPointsAlike) {
  Random random;
  const ParameterizedPoints points = random_grid(random, 12, 9, 1);
  const KnotVector u = KnotVector::clamped(2, std::vector{0.5, 0.5, 0.501, 0.502}),
                   v = KnotVector::uniform(2, 1);
  const LeastSquaresResult a = fit(points, u, v, true), b = fit(points, u, v, false);
  EXPECT_GT(a.empty_cells, 0);
  EXPECT_EQ(a.empty_cells, b.empty_cells);
}

TEST(GridRoute, SolvesOnFewerLinesThanFunctions) {
  Random random;
  for (const auto& [lines_u, lines_v] : {std::pair{3, 200}, {200, 3}, {2, 300}}) {
    const ParameterizedPoints points = random_grid(random, lines_u, lines_v, 2);
    const KnotVector u = KnotVector::uniform(3, lines_u < 10 ? 4 : 20);
    const KnotVector v = KnotVector::uniform(3, lines_v < 10 ? 4 : 20);
    for (bool grid : {true, false}) {
      const LeastSquaresResult result = fit(points, u, v, grid);
      for (double x : result.surface.net()) ASSERT_TRUE(std::isfinite(x));
      // Values in [-1,1]: a surface between few lines must not fly off either.
      EXPECT_LT(result.surface.scale(), 100) << lines_u << " x " << lines_v << " lines, grid " << grid;
      EXPECT_LE(result.error.max, 2);
    }
  }
}

TEST(GridRoute, AsManyFunctionsAsLinesInterpolates) {
  Random random;
  const ParameterizedPoints points = random_grid(random, 12, 12, 1);
  // Degree 1 with a knot at every inner line.
  std::vector<double> u, v;
  for (int i = 1; i < 11; ++i) u.push_back(points.u(i * 12));
  for (int j = 1; j < 11; ++j) v.push_back(points.v(j));
  const LeastSquaresResult result = fit(points, KnotVector::clamped(1, u), KnotVector::clamped(1, v), true);
  EXPECT_LT(result.error.max, 1e-12);
}

TEST(GridRoute, TransposingTheDataTransposesTheNet) {
  Random random;
  const ParameterizedPoints points = random_grid(random, 25, 40, 2);
  ParameterizedPoints turned = points;
  for (Index k = 0; k < points.size(); ++k) std::swap(turned.uv[2 * k], turned.uv[2 * k + 1]);
  const KnotVector u = KnotVector::uniform(3, 5), v = KnotVector::uniform(2, 7);
  const Surface a = transposed(fit(points, u, v, true).surface), b = fit(turned, v, u, true).surface;
  for (std::size_t k = 0; k < a.net().size(); ++k) EXPECT_NEAR(a.net()[k], b.net()[k], 1e-11);
}

TEST(GridRoute, TheOrderOfThePointsDoesNotMatter) {
  Random random;
  const ParameterizedPoints points = random_grid(random, 20, 25, 1);
  ParameterizedPoints reversed = points;
  std::reverse(reversed.values.begin(), reversed.values.end());
  for (Index k = 0; k < points.size(); ++k)
    for (int axis : {0, 1}) reversed.uv[2 * k + axis] = points.uv[2 * (points.size() - 1 - k) + axis];
  const KnotVector u = KnotVector::uniform(3, 5), v = KnotVector::uniform(3, 7);
  const LeastSquaresResult a = fit(points, u, v, true), b = fit(reversed, u, v, true);
  EXPECT_EQ(a.surface, b.surface);
  for (Index k = 0; k < points.size(); ++k) EXPECT_EQ(a.errors[k], b.errors[points.size() - 1 - k]);
}

TEST(GridRoute, SameBitsForOneAndTwoThreads) {
  Random random;
  const ParameterizedPoints points = random_grid(random, 300, 200, 3);
  const KnotVector u = KnotVector::uniform(3, 60), v = KnotVector::uniform(3, 45);
  std::vector<double> net, errors;
  for (int threads : {1, 2, 4}) {
    set_thread_count(threads);
    const LeastSquaresResult result = fit(points, u, v, true);
    if (threads == 1) {
      net = result.surface.net();
      errors = result.errors;
    }
    EXPECT_EQ(result.surface.net(), net);
    EXPECT_EQ(result.errors, errors);
  }
  set_thread_count(0);
}

}  // namespace
}  // namespace knotfit::test
