#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
#include "knotfit/features.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

ParameterizedPoints at(std::vector<double> uv) {
  ParameterizedPoints points;
  points.values.assign(uv.size() / 2, 0.0);
  points.uv = std::move(uv);
  return points;
}

TEST(PointFeatures, AreAveragedOverEachCell) {
  Random random;
  ParameterizedPoints points = at(random_numbers(random, 2000));
  for (double& x : points.uv) x = (x + 1) / 2;
  std::vector<double> f = random_numbers(random, 1000);
  for (double& x : f) x = std::abs(x);
  const FeatureMap map = point_features(points, f, 8);
  for (Index i = 0; i < 8; ++i)
    for (Index j = 0; j < 8; ++j) {
      double sum = 0, count = 0;
      for (Index k = 0; k < 1000; ++k)
        if (std::floor(points.u(k) * 8) == static_cast<double>(i) &&
            std::floor(points.v(k) * 8) == static_cast<double>(j)) {
          sum += f[k];
          ++count;
        }
      ASSERT_GT(count, 0);
      EXPECT_NEAR(map.f[i * 8 + j], sum / count, 1000 * kEps);
    }
}

TEST(PointFeatures, PointsOnTheLastBorderBelongToTheLastCell) {
  const FeatureMap map = point_features(at({1, 1, 0, 0, 0, 1, 1, 0}), {4, 1, 2, 3}, 2);
  EXPECT_EQ(map.f, (std::vector<double>{1, 2, 3, 4}));
}

TEST(PointFeatures, EmptyCellsTakeTheNearestValue) {
  // Points in two corners of 7 x 7 cells: every cell takes the value of the nearer corner by steps.
  const FeatureMap map = point_features(at({0, 0, 1, 1}), {1, 5}, 7);
  for (Index i = 0; i < 7; ++i)
    for (Index j = 0; j < 7; ++j) {
      const Index first = i + j, second = 12 - i - j;
      if (first == second) continue;
      EXPECT_EQ(map.f[i * 7 + j], first < second ? 1 : 5) << i << ", " << j;
    }
}

TEST(PointFeatures, OfOnePointAreTheSameEverywhere) {
  for (double x : point_features(at({0.3, 0.9}), {2.5}, 50).f) EXPECT_EQ(x, 2.5);
}

TEST(ResidualFeatures, AreTheSquaredErrors) {
  const FeatureMap map = residual_features(at({0.1, 0.1, 0.2, 0.2, 0.9, 0.9}), {1, 2, 3}, 2);
  EXPECT_EQ(map.f[0], 2.5);
  EXPECT_EQ(map.f[3], 9);
}

TEST(PointFeatures, NameThePointOfABadValue) {
  for (double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    expect_throw<InvalidInput>(
        [&] {
          point_features(at({0, 0, 1, 1}), {1, bad}, 4);
        },
        "the feature value of point 1 is");
  expect_throw<InvalidInput>(
      [] {
        residual_features(at({0, 0, 1, 1}), {std::numeric_limits<double>::quiet_NaN(), 1}, 4);
      },
      "the feature value of point 0 is nan: it must be finite and at least 0");
}

TEST(PointFeatures, NeedOneValueAPoint) {
  expect_throw<InvalidInput>(
      [] {
        point_features(at({0, 0, 1, 1}), {1}, 4);
      },
      "1 feature values for 2 points");
}

TEST(PointFeatures, NeedPointsAndACell) {
  expect_throw<InvalidInput>([] { point_features(at({}), {}, 4); }, "no points");
  expect_throw<InvalidInput>([] { point_features(at({2, 0}), {1}, 4); }, "point 0 has parameters (2, 0)");
  expect_throw<InvalidInput>([] { point_features(at({0, 0}), {1}, 0); }, "at least one cell");
}

}  // namespace
}  // namespace knotfit::test
