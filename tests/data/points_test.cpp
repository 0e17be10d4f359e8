#include "knotfit/points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Three points in R^2.
ParameterizedPoints three() {
  ParameterizedPoints points;
  points.dimension = 2;
  points.uv = {0, 0, 1, 0.5, 0.25, 1};
  points.values = {1, 2, 3, 4, 5, 6};
  points.weights = {1, 2, 0.5};
  points.source = {10, 11, 12};
  return points;
}

TEST(ParameterMap, ShearAndBackIsTheIdentity) {
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    ParameterMap map{.u0 = -3, .u1 = 5, .v0 = 100, .v1 = 101};
    (trial % 2 == 0 ? map.shear_u : map.shear_v) = random.uniform(-1, 1);
    const double a = random.uniform(-3, 5), b = random.uniform(100, 101);
    const auto [u, v] = map.to_uv(a, b);
    EXPECT_TRUE(u >= 0 && u <= 1 && v >= 0 && v <= 1);
    EXPECT_TRUE(map.covers(u, v));
    const auto [x, y] = map.from_uv(u, v);
    EXPECT_NEAR(x, a, 1e-14 * 8);
    EXPECT_NEAR(y, b, 1e-14 * 101);
  }
}

TEST(ParameterMap, ShearFillsTheSquareAndLeavesTwoCornersFree) {
  const ParameterMap map{.shear_u = 0.5};
  EXPECT_EQ(map.to_uv(0, 0), (std::array{0.0, 0.0}));
  EXPECT_EQ(map.to_uv(1, 1), (std::array{1.0, 1.0}));
  EXPECT_TRUE(map.covers(0, 0) && map.covers(1, 1));
  EXPECT_FALSE(map.covers(1, 0));
  EXPECT_FALSE(map.covers(0, 1));
  const ParameterMap back{.shear_u = -0.5};
  EXPECT_EQ(back.to_uv(0, 1)[0], 0.0);
  EXPECT_EQ(back.to_uv(1, 0)[0], 1.0);
}

TEST(Points, ShearedKeepTheUsersPlaces) {
  ParameterizedPoints points;
  points.uv = {0, 0, 1, 0.5, 0.25, 1};
  points.values = {1, 2, 3};
  const ParameterizedPoints oblique = sheared(points, 0, -0.25);
  EXPECT_EQ(oblique.values, points.values);
  for (Index k = 0; k < points.size(); ++k) {
    const auto [x, y] = oblique.map.from_uv(oblique.u(k), oblique.v(k));
    EXPECT_NEAR(x, points.u(k), 1e-15);
    EXPECT_NEAR(y, points.v(k), 1e-15);
  }
  expect_throw<InvalidInput>([&] { sheared(points, 0.1, 0.1); }, "one must be 0");
  expect_throw<InvalidInput>([&] { sheared(points, 1.5, 0); }, "[-1,1]");
  expect_throw<InvalidInput>([&] { sheared(points, NAN, 0); }, "[-1,1]");
}

void expect_invalid(const ParameterizedPoints& points, const std::string& words) {
  expect_throw<InvalidInput>([&] { validate(points); }, words);
}

TEST(Points, ValidOnesPass) {
  validate(three());
  ParameterizedPoints plain = three();
  plain.weights.clear();
  plain.source.clear();
  validate(plain);
}

TEST(Points, MustHaveADimension) {
  ParameterizedPoints points = three();
  points.dimension = 0;
  expect_invalid(points, "points of dimension 0: it must be at least 1");
}

TEST(Points, MustExist) {
  expect_invalid({}, "no points to fit");
}

TEST(Points, NeedAsManyValuesAsParameters) {
  ParameterizedPoints points = three();
  points.values.pop_back();
  expect_invalid(points, "6 parameters for 5 values of dimension 2: one (u, v) a point is needed");
  points = three();
  points.uv.push_back(0);
  expect_invalid(points, "7 parameters for 6 values");
}

TEST(Points, NeedNoWeightsOrOneEach) {
  ParameterizedPoints points = three();
  points.weights.pop_back();
  expect_invalid(points, "2 weights for 3 points");
}

TEST(Points, NeedNoSourceLinesOrOneEach) {
  ParameterizedPoints points = three();
  points.source.pop_back();
  expect_invalid(points, "2 source lines for 3 points");
}

TEST(Points, ParametersOutsideTheUnitSquareAreNamedWithTheirLine) {
  for (double bad : {-1e-300, 1 + kEps, kNan, kInfinity, -kInfinity})
    for (int axis : {0, 1}) {
      ParameterizedPoints points = three();
      points.uv[2 + axis] = bad;
      expect_invalid(points, "point 1 (line 11) has parameters (");
      expect_invalid(points, "outside [0,1]; rescale the parameters");
      points.source.clear();
      expect_invalid(points, "point 1 has parameters (");
    }
}

TEST(Points, ValuesMustBeFinite) {
  for (double bad : {kNan, kInfinity, -kInfinity}) {
    ParameterizedPoints points = three();
    points.values[5] = bad;
    expect_invalid(points, "point 2 (line 12) has a value that is not finite");
  }
}

TEST(Points, WeightsMustBePositiveAndFinite) {
  for (double bad : {0.0, -1.0, kNan, kInfinity}) {
    ParameterizedPoints points = three();
    points.weights[0] = bad;
    expect_invalid(points, "point 0 (line 10) has weight");
    expect_invalid(points, "weights must be positive and finite");
  }
}

TEST(Points, DiagonalOfHeightsIsTheirRange) {
  ParameterizedPoints points;
  points.uv = {0, 0, 1, 1, 0, 1};
  points.values = {-2, 5, 1};
  EXPECT_EQ(bounding_diagonal(points), 7);
}

TEST(Points, DiagonalInSpaceIsThatOfTheBox) {
  ParameterizedPoints points;
  points.dimension = 3;
  points.uv = {0, 0, 1, 1};
  points.values = {1, 1, 1, 3, 4, 7};
  EXPECT_NEAR(bounding_diagonal(points), 7, 16 * kEps);  // sqrt(2^2 + 3^2 + 6^2)
}

TEST(Points, DiagonalOfHugeAndTinyBoxesIsFinite) {
  for (double scale : {1e300, 1e-300}) {
    ParameterizedPoints points;
    points.dimension = 2;
    points.uv = {0, 0, 1, 1};
    points.values = {0, 0, 3 * scale, 4 * scale};
    EXPECT_NEAR(bounding_diagonal(points) / scale, 5, 16 * kEps);
  }
}

TEST(Points, DiagonalOfOnePointOrNoneIsZero) {
  ParameterizedPoints points;
  EXPECT_EQ(bounding_diagonal(points), 0);
  points.uv = {0, 0};
  points.values = {4};
  EXPECT_EQ(bounding_diagonal(points), 0);
}

TEST(Points, ParameterMapLeadsThereAndBack) {
  ParameterMap map;
  EXPECT_TRUE(map.identity());
  map.u0 = 100;
  map.u1 = 300;
  map.v0 = -1;
  map.v1 = 0;
  EXPECT_FALSE(map.identity());
  EXPECT_EQ(map.to_u(150), 0.25);
  EXPECT_EQ(map.from_u(0.25), 150);
  EXPECT_EQ(map.to_v(-0.5), 0.5);
  EXPECT_EQ(map.from_v(0.5), -0.5);
}

}  // namespace
}  // namespace knotfit::test
