#include <gtest/gtest.h>

#include "knotfit/exceptions.h"
#include "pipeline/fits.h"
#include "pipeline/refused.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

TEST(Refusals, FewerPointsThanOnePatch) {
  const ParameterizedPoints points = synthetic_points("franke", 15);
  expect_refused(points, to_tolerance(1e-2),
                 "15 points are fewer than the 16 control points of one patch of degree 3x3");
  expect_refused(points, to_tolerance(1e-2), "give more points or a lower `degree`");
  FitOptions lower = to_tolerance(0.5);
  lower.degree_u = lower.degree_v = 2;
  EXPECT_NE(fit_surface(points, lower).status, Status::not_run);
}

TEST(Refusals, FewerPointsThanControlPointsAsked) {
  const ParameterizedPoints points = synthetic_points("franke", 99);
  expect_refused(points, at_size(10, 10), "99 points are fewer than 10 x 10 = 100 control points");
  expect_refused(points, at_size(10, 10), "ask for fewer control points or a lower `degree`");
  FitOptions given = to_tolerance(1e-2);
  given.knots = InteriorKnots{std::vector<double>(6, 0.0), std::vector<double>(6, 0.0)};
  expect_refused(points, given, "99 points are fewer than 10 x 10");
}

TEST(Refusals, SizesBelowOnePatch) {
  const ParameterizedPoints points = synthetic_points("franke", 99);
  expect_refused(points, at_size(3, 8), "3 x 8 control points: degree 3x3 needs at least 4 x 4");
  expect_refused(points, at_size(8, 0), "8 x 0 control points");
  expect_refused(points, at_size(-5, 8), "-5 x 8 control points");
  expect_refused(points, at_size(-5, -8), "-5 x -8 control points");
}

TEST(Refusals, NothingAskedFor) {
  FitOptions options = to_tolerance(1);
  options.tolerance.reset();
  expect_refused(synthetic_points("franke", 99), options,
                 "give a tolerance, a number of control points, or knots");
}

TEST(Refusals, Degrees) {
  const ParameterizedPoints points = synthetic_points("franke", 200);
  for (int degree : {0, -1, 10, 100}) {
    FitOptions options = to_tolerance(1e-2);
    options.degree_u = degree;
    expect_refused(points, options, "degree " + std::to_string(degree) + ": it must be 1 to 9");
    options = to_tolerance(1e-2);
    options.degree_v = degree;
    expect_refused(points, options, "degree " + std::to_string(degree) + ": it must be 1 to 9");
  }
}

TEST(Refusals, PointsThatAreAllEqual) {
  ParameterizedPoints points = synthetic_points("torus", 200);
  for (double scale : {1.0, 1e8, 1e-200}) {
    for (Index k = 0; k < points.size(); ++k)
      for (int d = 0; d < 3; ++d) points.values[3 * k + d] = scale * (d + 1);
    expect_refused(points, to_tolerance(1e-2 * scale), "all points are equal: there is no surface to fit");
  }
}

TEST(Refusals, PointsOnAStraightLine) {
  ParameterizedPoints points = synthetic_points("torus", 200);
  for (double scale : {1.0, 1e8, 1e-200, 1e200}) {
    for (Index k = 0; k < points.size(); ++k) {
      const double t = points.u(k) - points.v(k);
      points.values[3 * k] = scale * (1 + t);
      points.values[3 * k + 1] = scale * (2 - 3 * t);
      points.values[3 * k + 2] = scale * 0.1 * t;
    }
    expect_refused(points, to_tolerance(1e-2 * scale), "all points lie on one straight line");
  }
  // A hair off the line is a surface.
  points.values[0] += 1e190;
  EXPECT_NE(fit_surface(points, to_tolerance(1e198)).status, Status::not_run);
}

TEST(Refusals, ParametersThatDoNotSpread) {
  ParameterizedPoints points = synthetic_points("franke", 200);
  ParameterizedPoints flat = points;
  for (Index k = 0; k < points.size(); ++k) flat.uv[2 * k] = 0.25;
  expect_refused(flat, to_tolerance(1e-2), "all points have the same parameter u = 0.25");
  flat = points;
  for (Index k = 0; k < points.size(); ++k) flat.uv[2 * k + 1] = 1;
  expect_refused(flat, to_tolerance(1e-2), "all points have the same parameter v = 1");
  for (double slope : {1.0, -1.0, 0.3}) {
    ParameterizedPoints line = points;
    for (Index k = 0; k < points.size(); ++k)
      line.uv[2 * k + 1] = slope > 0 ? slope * points.u(k) : 1 + slope * points.u(k);
    expect_refused(line, to_tolerance(1e-2), "the parameters (u, v) of all points lie on one straight line");
  }
}

TEST(Refusals, Tolerances) {
  const ParameterizedPoints points = synthetic_points("franke", 200);
  for (double bad : {0.0, -1e-3, kNan, kInfinity}) {
    expect_refused(points, to_tolerance(bad), "it must be positive and finite");
    FitOptions relative = to_tolerance(bad);
    relative.tolerance->relative = true;
    expect_refused(points, relative, "it must be positive and finite");
  }
  expect_refused(points, to_tolerance(-0.5), "the tolerance is -0.5");
  for (double share : {0.0, -0.1, 1.01, kNan}) {
    FitOptions options = to_tolerance(1e-2);
    options.tolerance->measure = ErrorMeasure::percentile;
    options.tolerance->share = share;
    expect_refused(points, options, "it must lie in (0, 100]");
  }
}

TEST(Refusals, TolerancesBelowRounding) {
  ParameterizedPoints points = synthetic_points("franke", 200);
  for (double& x : points.values) x += 1e8;
  expect_refused(points, to_tolerance(1e-8),
                 "the tolerance 1e-08 is below what coordinates of this size can hold in double precision");
  expect_refused(points, to_tolerance(1e-8), "move the data nearer to the origin");
  FitOptions fixed = at_size(5, 5);
  fixed.tolerance = ToleranceRequest{.value = 1e-9};
  expect_refused(points, fixed, "is below what coordinates");
}

TEST(Refusals, PercentOfNothing) {
  ParameterizedPoints points = synthetic_points("franke", 200);
  points.values.assign(200, 3.0);
  FitOptions options = to_tolerance(1);
  options.tolerance->relative = true;
  expect_refused(points, options, "all values are equal, so a tolerance in % of their range means nothing");
}

}  // namespace
}  // namespace knotfit::test
