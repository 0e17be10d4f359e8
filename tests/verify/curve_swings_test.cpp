// Whether a curve keeps to its data between points that stand side by side.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "knotfit/exceptions.h"
#include "knotfit/verify.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

CurvePoints graph(const std::vector<double>& t, const std::function<double(double)>& f) {
  CurvePoints points;
  points.dimension = 1;
  points.t = t;
  for (double x : t) points.values.push_back(f(x));
  return points;
}

std::vector<double> even(int n) {
  std::vector<double> t;
  for (int k = 0; k < n; ++k) t.push_back(k / (n - 1.0));
  return t;
}

/// y = 0 but for the one function between these knots, a cubic B-spline that peaks at 2/3 of `height`.
Curve with_peak(const std::vector<double>& knots, double height) {
  const KnotVector vector = KnotVector::clamped(3, knots);
  std::vector<double> net(static_cast<std::size_t>(vector.size()), 0.0);
  net[4] = height;
  return Curve(vector, 1, net);
}

SwingReport swings_of(const Curve& curve, const CurvePoints& points, double tolerance) {
  std::vector<double> errors = evaluate(curve, points.t);
  for (Index k = 0; k < points.size(); ++k) errors[k] = std::abs(errors[k] - points.values[k]);
  return measure_swings(curve, points, errors, tolerance);
}

TEST(CurveSwings, OfALineAreNone) {
  const CurvePoints points = graph(even(50), [](double t) { return 2 - t; });
  const Curve line(KnotVector::clamped(1, std::vector<double>{}), 1, {2, 1});
  const SwingReport report = swings_of(line, points, 1e-6);
  EXPECT_TRUE(report.measured);
  EXPECT_GT(report.places, 900);
  EXPECT_EQ(report.largest, 0);
  EXPECT_EQ(report.above, 0);
  EXPECT_FALSE(report.swings);
}

// A cubic basis function of equal spans peaks at 2/3 of its control point.
TEST(CurveSwings, OfAPeakBetweenPointsAreItsHeightOverTheTolerance) {
  const CurvePoints points = graph(even(51), [](double) { return 0.0; });
  // The function lives on 0.502 .. 0.518, between the points 0.5 and 0.52.
  const SwingReport report = swings_of(with_peak({0.502, 0.506, 0.51, 0.514, 0.518}, 0.3), points, 0.01);
  EXPECT_NEAR(report.largest, 20, 0.3);
  EXPECT_NEAR(report.distance, 0.2, 0.003);
  EXPECT_NEAR(report.worst_u, 0.51, 0.001);
  EXPECT_NEAR(report.beyond_box, 0.2, 0.003);
  EXPECT_TRUE(report.swings);
  EXPECT_FALSE(swings_of(with_peak({0.502, 0.506, 0.51, 0.514, 0.518}, 0.015), points, 0.01).swings);
}

// However narrow a span is next to a point, places are in it.
TEST(CurveSwings, APeakInANarrowSpanIsFound) {
  const CurvePoints points = graph(even(51), [](double) { return 0.0; });
  const SwingReport report =
      swings_of(with_peak({0.5 + 1e-7, 0.5 + 2e-7, 0.5 + 3e-7, 0.5 + 4e-7, 0.5 + 5e-7}, 0.3), points, 0.01);
  EXPECT_GT(report.largest, 15);
  EXPECT_TRUE(report.swings);
}

// 24 points of a circle: the arcs between leave the boxes of their points, and the points say so.
TEST(CurveSwings, CrestsOfSmoothDataAreNone) {
  const double full = 2 * std::acos(-1.0);
  const CurvePoints few = graph(even(24), [&](double t) { return std::sin(full * t); });
  // A fine interpolant of the same wave.
  std::vector<double> knots;
  for (int k = 1; k < 60; ++k) knots.push_back(k / 60.0);
  const KnotVector vector = KnotVector::clamped(3, knots);
  std::vector<double> net;
  for (Index i = 0; i < vector.size(); ++i) {  // Greville points: within 1e-3 of the wave
    double mean = 0;
    for (int j = 1; j <= 3; ++j) mean += vector[i + j] / 3;
    net.push_back(std::sin(full * mean));
  }
  const SwingReport report = swings_of(Curve(vector, 1, net), few, 1e-3);
  EXPECT_LE(report.largest, 3);
  EXPECT_FALSE(report.swings);
}

// In a gap the data says less: as much as its range, the more the wider the gap.
TEST(CurveSwings, GapsAllowMore) {
  std::vector<double> t;
  for (int k = 0; k <= 40; ++k) t.push_back(0.4 * k / 40), t.push_back(0.6 + 0.4 * k / 40);
  const auto f = [](double x) { return std::sin(8 * x); };
  const CurvePoints points = graph(t, f);
  std::vector<double> errors(t.size(), 0.0);
  // The wave itself through the gap, and one that leaves it by five times its height there.
  std::vector<double> knots;
  for (int k = 1; k < 40; ++k) knots.push_back(k / 40.0);
  const KnotVector vector = KnotVector::clamped(3, knots);
  std::vector<double> net;
  for (Index i = 0; i < vector.size(); ++i)
    net.push_back(f((vector[i + 1] + vector[i + 2] + vector[i + 3]) / 3));
  const SwingReport right = measure_swings(Curve(vector, 1, net), points, errors, 0.01);
  EXPECT_FALSE(right.swings) << right.largest << " at " << right.worst_u << ", " << right.above << ", "
                             << right.beyond_box << " at " << right.box_u;
  net[21] += 100;
  const SwingReport wild = measure_swings(Curve(vector, 1, net), points, errors, 0.01);
  EXPECT_TRUE(wild.swings);
  EXPECT_NEAR(wild.worst_u, 0.5, 0.06);
}

// The period goes on: places at the seam have points on both sides.
TEST(CurveSwings, AClosedCurveHasNoEnds) {
  const double full = 2 * std::acos(-1.0);
  CurvePoints points;
  points.closed = true;
  for (int k = 0; k < 60; ++k) {
    points.t.push_back((k + 0.5) / 60);
    points.values.insert(points.values.end(),
                         {std::cos(full * points.t.back()), std::sin(full * points.t.back())});
  }
  // Right everywhere but for a flick at the very start of the period.
  std::vector<double> knots = {0.001, 0.002, 0.003, 0.004};
  for (int k = 1; k < 100; ++k) knots.push_back(k / 100.0);
  const KnotVector vector = KnotVector::clamped(3, knots);
  std::vector<double> net;
  for (Index i = 0; i < vector.size(); ++i) {
    const double t = (vector[i + 1] + vector[i + 2] + vector[i + 3]) / 3;
    net.insert(net.end(), {std::cos(full * t), std::sin(full * t)});
  }
  std::vector<double> errors(60, 0.0);
  EXPECT_FALSE(measure_swings(Curve(vector, 2, net), points, errors, 0.005).swings);
  net[2 * 3 + 1] += 1;
  const SwingReport report = measure_swings(Curve(vector, 2, net), points, errors, 0.005);
  EXPECT_TRUE(report.swings);
  EXPECT_LT(report.worst_u, 0.005);
}

TEST(CurveSwings, RefuseWhatDoesNotBelongTogether) {
  const CurvePoints points = graph(even(10), [](double t) { return t; });
  const Curve line(KnotVector::clamped(1, std::vector<double>{}), 1, {0, 1});
  const std::vector<double> errors(10, 0.0);
  expect_throw<InvalidInput>([&] { measure_swings(line, points, errors, 0); }, "a tolerance of 0");
  expect_throw<InvalidInput>([&] { measure_swings(line, points, {0, 0}, 1); }, "2 errors of 10 points");
  expect_throw<InvalidInput>(
      [&] {
        measure_swings(Curve(KnotVector::clamped(1, std::vector<double>{}), 2, {0, 1, 1, 1}), points, errors,
                       1);
      },
      "of the dimension of its points");
}

}  // namespace
}  // namespace knotfit::test
