#include "pipeline/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "knotfit/evaluate.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

ParameterizedPoints random_points(Random& random, Index n, int dimension) {
  ParameterizedPoints points;
  points.dimension = dimension;
  points.uv.assign(static_cast<std::size_t>(2 * n), 0.5);
  points.values = random_numbers(random, n * dimension);
  return points;
}

TEST(Frame, PutsTheDataIntoTheUnitCube) {
  Random random;
  for (double size : {1e-12, 1.0, 3e7})
    for (double offset : {0.0, -4.6e6, 1e8}) {
      ParameterizedPoints points = random_points(random, 100, 3);
      for (std::size_t k = 0; k < points.values.size(); ++k)
        points.values[k] = points.values[k] * size + offset * static_cast<double>(k % 3);
      const Frame frame(points);
      const ParameterizedPoints inside = frame.inside(points);
      double most = 0;
      for (double x : inside.values) most = std::max(most, std::abs(x));
      EXPECT_LE(most, 1 + kEps);
      EXPECT_GT(most, 0.25);
      EXPECT_EQ(inside.uv, points.uv);
      EXPECT_EQ(std::exp2(std::round(std::log2(frame.scale()))), frame.scale());  // a power of two
    }
}

TEST(Frame, LeadsBackToTheDataWithinItsRounding) {
  Random random;
  ParameterizedPoints points = random_points(random, 60, 2);
  for (double& x : points.values) x = 1e8 + x;
  const Frame frame(points);
  const ParameterizedPoints inside = frame.inside(points);
  // A surface of degree 1 through given control points: its net is undone like data.
  const KnotVector knots = KnotVector::uniform(1, 0);
  const Surface s(knots, knots, 2, std::vector<double>(inside.values.begin(), inside.values.begin() + 8));
  const Surface out = frame.outside(s);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(out.net()[k], points.values[k], 2 * frame.rounding());
}

TEST(Frame, RoundingIsHalfAnUlpOfTheLargestCoordinate) {
  ParameterizedPoints points;
  points.uv = {0, 0, 1, 1};
  points.values = {-1e8, 3};
  EXPECT_NEAR(Frame(points).rounding(), 1e8 * 0x1p-53, 1e-12);
}

TEST(Frame, OfEqualValuesChangesTheCentreOnly) {
  ParameterizedPoints points;
  points.uv = {0, 0, 1, 1};
  points.values = {7, 7};
  const Frame frame(points);
  EXPECT_EQ(frame.scale(), 1);
  EXPECT_EQ(frame.inside(points).values, (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace knotfit::test
