#include "nearest/curve_feet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fit/curve_problem.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

TEST(CurveFeet, AreTheNearestPlaces) {
  // A quarter of a parabola: the foot is known by a fine search.
  const Curve curve(KnotVector::uniform(2, 0), 2, {0, 0, 0.5, 0, 1, 1});
  Random random(6);
  for (int run = 0; run < 50; ++run) {
    const double point[2] = {random.uniform(-0.2, 1.2), random.uniform(-0.2, 0.4)};
    double best = 0, least = INFINITY;
    for (int k = 0; k <= 20000; ++k) {
      const double t = k / 20000.0, distance = std::hypot(t - point[0], t * t - point[1]);
      if (distance < least) {
        least = distance;
        best = t;
      }
    }
    double t[1] = {std::clamp(best + 0.05, 0.0, 1.0)};
    const std::vector<double> squared = curve_feet(curve, false, point, t);
    EXPECT_NEAR(std::hypot(t[0] - point[0], t[0] * t[0] - point[1]), least, 1e-8);
    EXPECT_NEAR(std::sqrt(squared[0]), least, 1e-8);
  }
}

TEST(CurveFeet, LieWhereTheCurveIsSquareToTheWay) {
  Random random(7);
  for (int run = 0; run < 40; ++run) {
    const int d = random.integer(2, 3);
    const KnotVector knots = random_knots(random, random.integer(2, 5), Ends::any, 5, 1);
    const Curve curve(knots, d, random_numbers(random, knots.size() * d));
    // A point beside the curve, nearer than it bends: its foot is where it was set out from.
    const double width = knots.last() - knots.first(),
                 foot = knots.first() + width * random.uniform(0.1, 0.9);
    const std::vector<double> c = evaluate_derivatives(curve, foot, 1);
    double speed = 0;
    for (int e = 0; e < d; ++e) speed += c[d + e] * c[d + e];
    const double away = 1e-4 / std::sqrt(speed);
    std::vector<double> point(c.begin(), c.begin() + d);
    point[0] -= away * c[d + 1];
    point[1] += away * c[d];
    double t[1] = {foot + 1e-4 * width * random.uniform(-1, 1)};
    curve_feet(curve, false, point, t);
    EXPECT_NEAR(t[0], foot, 1e-6 * width);
  }
}

TEST(CurveFeet, GoRoundAClosedCurve) {
  CurvePoints points;
  points.closed = true;
  for (int k = 0; k < 60; ++k) {
    points.t.push_back(k / 60.0);
    points.values.insert(points.values.end(),
                         {std::cos(2 * std::numbers::pi * k / 60), std::sin(2 * std::numbers::pi * k / 60)});
  }
  CurveProblem problem(points, 3, 1e-12);
  ASSERT_TRUE(problem.solve({0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875}));
  for (const double angle : {-0.02, 0.3}) {
    const double point[2] = {1.2 * std::cos(angle), 1.2 * std::sin(angle)};
    double t[1] = {angle < 0 ? 0.01 : 0.99};
    curve_feet(problem.curve(), true, point, t);
    EXPECT_NEAR(t[0], (angle < 0 ? 1 : 0) + angle / (2 * std::numbers::pi), 1e-3);
  }
}

TEST(CurveFeet, AreOfCurvesInSpace) {
  double t[1] = {0.5};
  const double point[4] = {0, 0, 0, 0};
  const Curve curve(KnotVector::uniform(1, 0), 4, {0, 0, 0, 0, 1, 1, 1, 1});
  expect_throw<InvalidInput>([&] { curve_feet(curve, false, point, t); }, "R^4");
}

}  // namespace
}  // namespace knotfit::test
