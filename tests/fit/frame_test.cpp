#include "fit/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
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

TEST(Frame, OfValuesBelowTheNormalNumbersHasAnInverse) {
  ParameterizedPoints points;
  points.uv = {0, 0, 1, 1};
  points.values = {0, 1e-310};
  for (const double x : Frame(points).inside(points).values) EXPECT_LE(std::abs(x), 1);
}

Mesh tilted_square() {
  Mesh mesh;
  mesh.vertices = {5, 5, 5, 8, 5, 5, 8, 9, 17, 5, 9, 17, 1e9, 0, 0};  // no face has the last one
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(Frame, OfAMeshIsTheBoxOfItsFaces) {
  const Frame frame(tilted_square());
  EXPECT_DOUBLE_EQ(frame.scale(), 13);  // 3, 4, 12
  const std::vector<Vec3> inside = frame.inside(tilted_square());
  ASSERT_EQ(inside.size(), 5u);
  EXPECT_DOUBLE_EQ(inside[2].x, 1.5 / 13);
  EXPECT_DOUBLE_EQ(inside[2].y, 2.0 / 13);
  EXPECT_DOUBLE_EQ(inside[2].z, 6.0 / 13);
  EXPECT_DOUBLE_EQ(length(inside[2] - inside[0]), 1);
}

TEST(Frame, OfAMeshTakesSurfacesInAndOut) {
  const Frame frame(tilted_square());
  const KnotVector knots = KnotVector::uniform(1, 0);
  const std::vector<double> net{5, 5, 5, 8, 5, 5, 8, 9, 17, 5, 9, 17};
  const Surface out = frame.outside(frame.inside(Surface(knots, knots, 3, net)));
  for (std::size_t k = 0; k < net.size(); ++k) EXPECT_NEAR(out.net()[k], net[k], 8 * frame.rounding());
}

TEST(Frame, OfAMeshWithoutExtentIsRefused) {
  Mesh mesh = tilted_square();
  mesh.vertices.assign(15, 3.0);
  expect_throw<InvalidInput>([&] { Frame{mesh}; }, "all vertices of the mesh are at one place");
  mesh.vertices[0] = std::numeric_limits<double>::infinity();
  expect_throw<InvalidInput>([&] { Frame{mesh}; }, "too far apart");
}

}  // namespace
}  // namespace knotfit::test
