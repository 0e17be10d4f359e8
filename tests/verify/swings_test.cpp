// Whether a surface keeps to its data between points that stand side by side.
#include "verify/swings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
#include "support/two_threads.h"
namespace knotfit::test {
namespace {

/// z = value over the square, with the control point (i, j) of 30 x 30 raised.
Surface plane_with_needle(double value, double raised, Index i, Index j) {
  std::vector<double> interior;
  for (int k = 1; k < 27; ++k) interior.push_back(k / 27.0);
  std::vector<double> net(900, value);
  net[i * 30 + j] += raised;
  return Surface(KnotVector::clamped(3, interior), KnotVector::clamped(3, interior), 1, net);
}

ParameterizedPoints flat_points(Index n) {
  ParameterizedPoints points = synthetic_points("franke", n);
  std::fill(points.values.begin(), points.values.end(), 1.0);
  return points;
}

TEST(Swings, OfAPlaneAreNone) {
  const ParameterizedPoints points = flat_points(2000);
  const SwingReport report =
      measure_swings(plane_with_needle(1, 0, 0, 0), points, std::vector<double>(2000, 0.0), 0.01);
  EXPECT_TRUE(report.measured);
  EXPECT_GT(report.places, 5000);
  EXPECT_LT(report.largest, 1e-10);  // rounding of the evaluation
  EXPECT_EQ(report.above, 0);
  EXPECT_LT(report.beyond_box, 1e-12);
  EXPECT_FALSE(report.swings);
}

// A bicubic basis function of uniform knots peaks at (2/3)^2 of its control point.
TEST(Swings, OfANeedleAreItsHeightOverTheTolerance) {
  const ParameterizedPoints points = flat_points(20000);
  const double tolerance = 0.01, height = 0.2 * 4 / 9;
  const SwingReport report = measure_swings(plane_with_needle(1, 0.2, 15, 15), points,
                                            std::vector<double>(points.size(), 0.0), tolerance);
  EXPECT_LE(report.distance, height * (1 + 1e-12));
  EXPECT_GT(report.largest, 0.9 * height / tolerance);
  EXPECT_GT(report.above, 0);
  EXPECT_NEAR(report.worst_u, 13.0 / 27 + 0.5 / 27, 0.03);
  EXPECT_GT(report.beyond_box, 0.9 * height);
  EXPECT_TRUE(report.swings);
}

// Where the points are as far off, nothing swings: the error says it already.
TEST(Swings, AreMeasuredAgainstTheErrorsThere) {
  const ParameterizedPoints points = flat_points(20000);
  const SwingReport report = measure_swings(plane_with_needle(1, 0.2, 15, 15), points,
                                            std::vector<double>(points.size(), 0.5), 0.01);
  EXPECT_LT(report.largest, 1);
  EXPECT_EQ(report.above, 0);
}

TEST(Swings, AreFoundInNarrowCellsBetweenRows) {
  // Rows 0.1 apart and two knots between two of them: no point sees what the surface does there.
  ParameterizedPoints points;
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 50; ++j) {
      points.uv.insert(points.uv.end(), {i / 10.0, j / 50.0});
      points.values.push_back(0);
    }
  const std::vector<double> u = {0.1, 0.2, 0.3, 0.4, 0.5, 0.52, 0.54, 0.56, 0.58, 0.6, 0.7, 0.8, 0.9};
  std::vector<double> net(17 * 4, 0.0);
  for (int j = 0; j < 4; ++j) net[8 * 4 + j] = 1;  // on 0.5 .. 0.58
  const Surface s(KnotVector::clamped(3, u), KnotVector::clamped(3, {}), 1, net);
  const SwingReport report = measure_swings(s, points, std::vector<double>(points.size(), 0.0), 0.01);
  EXPECT_GT(report.largest, 10);
  EXPECT_TRUE(report.swings);
}

// What a caller may fill in to hold the surface lies in the range of the data about.
// Waves with few points to one: their crests leave the box of the points about, and are what the data says.
TEST(Swings, AreNoneWhereTheDataItselfSaysSo) {
  ParameterizedPoints points = synthetic_points("franke", 6000);
  for (Index k = 0; k < points.size(); ++k)
    points.values[k] =
        std::sin(40 * points.u(k) + 9 * points.v(k)) + std::cos(38 * points.v(k) - 11 * points.u(k));
  std::vector<double> interior;
  for (int i = 1; i < 60; ++i) interior.push_back(i / 60.0);
  const KnotVector knots = KnotVector::clamped(3, interior);
  // The waves themselves, by their blossoms nearly: a quasi-interpolant of the truth.
  std::vector<double> net;
  for (Index i = 0; i < 63; ++i)
    for (Index j = 0; j < 63; ++j) {
      const double u = (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3,
                   v = (knots[j + 1] + knots[j + 2] + knots[j + 3]) / 3;
      net.push_back(std::sin(40 * u + 9 * v) + std::cos(38 * v - 11 * u));
    }
  const Surface s(knots, knots, 1, net);
  const std::vector<double> errors = recheck_errors(s, points);
  const SwingReport report = measure_swings(s, points, errors, 0.01);
  EXPECT_LE(report.above, 2);
  EXPECT_FALSE(report.swings);
}

TEST(Swings, StraysAreValuesTheDataAllows) {
  const ParameterizedPoints points = flat_points(5000);
  const verify::SwingSites sites(points, 10000);
  verify::SwingSites::Strays strays;
  sites.measure(plane_with_needle(1, 0.5, 15, 15), std::vector<double>(points.size(), 0.0), 0.01, &strays);
  ASSERT_FALSE(strays.values.empty());
  EXPECT_EQ(strays.uv.size(), 2 * strays.values.size());
  for (double value : strays.values) EXPECT_EQ(value, 1);
}

TEST(Swings, OfEqualParametersTheLargestErrorCounts) {
  ParameterizedPoints points = flat_points(3000);
  for (Index k = 0; k < 3000; ++k) {
    points.uv.insert(points.uv.end(), {points.u(k), points.v(k)});
    points.values.push_back(1);
  }
  std::vector<double> errors(6000, 0.0);
  std::fill(errors.begin() + 3000, errors.end(), 1.0);  // of the copies
  EXPECT_LT(measure_swings(plane_with_needle(1, 0.2, 15, 15), points, errors, 0.01).largest, 1);
}

TEST(Swings, SameForAnyNumberOfThreads) {
  const ParameterizedPoints points = synthetic_points("peaks", 3000);
  const auto [one, two] = on_one_and_two_threads([&] {
    return measure_swings(plane_with_needle(0, 3, 9, 20), points, std::vector<double>(3000, 0.01), 0.01);
  });
  EXPECT_EQ(one.largest, two.largest);
  EXPECT_EQ(one.above, two.above);
  EXPECT_EQ(one.worst_u, two.worst_u);
}

TEST(Swings, RefuseWhatDoesNotBelongTogether) {
  const ParameterizedPoints points = flat_points(100);
  const Surface s = plane_with_needle(0, 0, 0, 0);
  const std::vector<double> errors(100, 0.0);
  expect_throw<InvalidInput>([&] { measure_swings(s, points, errors, 0); }, "positive and finite");
  expect_throw<InvalidInput>([&] { measure_swings(s, points, std::vector<double>(99, 0.0), 1); },
                             "99 errors of 100 points");
  expect_throw<InvalidInput>([&] { measure_swings({}, points, errors, 1); }, "dimension of its points");
}

}  // namespace
}  // namespace knotfit::test
