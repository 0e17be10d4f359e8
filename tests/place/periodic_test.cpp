#include "place/periodic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fit/curve_problem.h"
#include "place/shares.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(Periodic, LowersTheErrorAndKeepsKnotsInOnePeriod) {
  CurvePoints points;
  points.closed = true;
  for (int k = 0; k < 200; ++k) {
    const double s = k / 200.0, a = 2 * std::numbers::pi * s, r = 1 + 0.5 * std::exp(-200 * square(s - 0.97));
    points.t.push_back(s);
    points.values.insert(points.values.end(), {r * std::cos(a), r * std::sin(a)});
  }
  CurveProblem problem(points, 3, 1e-12);
  // Without its first knot the second set begins beyond 1.
  for (const double seam : {0.0, 0.97}) {
    std::vector<double> knots{seam};
    for (double x : uniform_knots(9)) knots.push_back(seam + x);
    ASSERT_TRUE(problem.solve(knots));
    const double before = problem.phi(), after = optimize_period(problem, knots);
    EXPECT_LT(after, 0.1 * before);
    EXPECT_EQ(problem.phi(), after);
    EXPECT_EQ(knots.size(), 10u);
    EXPECT_GE(knots.front(), 0);
    EXPECT_LT(knots.front(), 1);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) EXPECT_LT(knots[i], knots[i + 1]);
    EXPECT_LT(knots.back(), knots.front() + 1);
  }
}

}  // namespace
}  // namespace knotfit::test
