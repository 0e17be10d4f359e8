#include "place/strip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/curve_problem.h"
#include "fit/fit_problem.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

CurvePoints planar(int n) {
  CurvePoints points;
  for (int k = 0; k < n; ++k) {
    const double t = k / (n - 1.0);
    points.t.push_back(t);
    points.values.insert(points.values.end(), {t, std::tanh(40 * (t - 0.3))});
  }
  return points;
}

// The strip's energy on the strip is the curve's on the curve.
TEST(Strip, HasTheEnergyOfTheCurve) {
  for (int dimension : {1, 2}) {
    CurvePoints points = planar(150);
    points.dimension = dimension;
    if (dimension == 1) {
      points.values.clear();
      for (double t : points.t) points.values.push_back(std::tanh(40 * (t - 0.3)));
    }
    for (int k = 0; k < points.size(); ++k) points.weights.push_back(1 + 0.5 * std::sin(k));
    const auto energy = std::make_shared<const DataEnergy>(strip_raster(points, 0.02));
    const std::vector<double> knots{0.1, 0.28, 0.31, 0.32, 0.33, 0.5};
    CurveProblem curve(points, 3, 1e-12, energy);
    ASSERT_TRUE(curve.solve(knots));
    LeastSquaresOptions options;
    options.smoothing = 1e-12;
    options.use_grid = false;
    options.energy = energy;
    const ParameterizedPoints strip = strip_of(points);
    FitProblem problem(strip, 3, 1, options);
    ASSERT_TRUE(problem.solve({knots, {}}));
    const Surface surface = problem.surface();
    for (Index i = 0; i < surface.size_u(); ++i)
      for (int e = 0; e < dimension; ++e) {
        EXPECT_NEAR(surface.control_point(i, 0)[e], curve.curve().control_points()[i * dimension + e], 1e-7);
        EXPECT_NEAR(surface.control_point(i, 1)[e], curve.curve().control_points()[i * dimension + e], 1e-7);
      }
  }
}

TEST(Strip, HasTheErrorsOfTheCurve) {
  for (int dimension : {1, 2}) {
    CurvePoints points = planar(150);
    if (dimension == 1) {
      points.dimension = 1;
      points.values.clear();
      for (double t : points.t) points.values.push_back(std::tanh(40 * (t - 0.3)));
    }
    const ParameterizedPoints strip = strip_of(points);
    EXPECT_EQ(strip.size(), 300);
    const std::vector<double> knots{0.1, 0.28, 0.31, 0.5};
    CurveProblem curve(points, 3, 1e-12);
    ASSERT_TRUE(curve.solve(knots));
    LeastSquaresOptions options;
    options.smoothing = 1e-12;
    FitProblem surface(strip, 3, 1, options);
    ASSERT_TRUE(surface.solve({knots, {}}));
    EXPECT_NEAR(surface.phi(), 2 * curve.phi(), 1e-8 * curve.phi());
  }
}

TEST(Strip, MergesEqualParametersByWeight) {
  CurvePoints points;
  points.dimension = 1;
  points.t = {0.5, 0, 0.5, 1};
  points.values = {1, 7, 4, 9};
  points.weights = {1, 1, 2, 1};
  const ParameterizedPoints strip = strip_of(points);
  EXPECT_EQ(strip.size(), 6);
  EXPECT_EQ(strip.uv, (std::vector<double>{0, 0, 0, 1, 0.5, 0, 0.5, 1, 1, 0, 1, 1}));
  EXPECT_EQ(strip.values, (std::vector<double>{7, 7, 3, 3, 9, 9}));
  EXPECT_EQ(strip.weights, (std::vector<double>{1, 1, 3, 3, 1, 1}));
}

TEST(Strip, AClosedCurveEndsWhereItStarts) {
  CurvePoints points = planar(5);
  points.closed = true;
  points.t = {0, 0.2, 0.4, 0.6, 0.8};
  const ParameterizedPoints strip = strip_of(points);
  EXPECT_EQ(strip.size(), 12);
  EXPECT_EQ(strip.u(11), 1);
  EXPECT_EQ(strip.value(11)[0], points.value(0)[0]);
}

TEST(CurveKnots, DominantPointsGatherWhereACurveBends) {
  PlacementOptions options;
  options.interior_u = 8;
  const std::vector<double> knots = place_curve_knots("dominant", planar(201), options).knots.u;
  EXPECT_GE(std::count_if(knots.begin(), knots.end(), [](double x) { return x > 0.15 && x < 0.45; }), 5);
}

}  // namespace
}  // namespace knotfit::test
