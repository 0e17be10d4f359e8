#include "knotfit/fit_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

CurvePoints function_points(int n, const std::function<double(double)>& f) {
  CurvePoints points;
  points.dimension = 1;
  points.function = true;
  for (int k = 0; k < n; ++k) {
    points.t.push_back(k / (n - 1.0));
    points.values.push_back(f(points.t.back()));
  }
  return points;
}

/// n points on an ellipse with a bump, unevenly spaced; closed.
CurvePoints loop(int n) {
  CurvePoints points;
  points.closed = true;
  for (int k = 0; k < n; ++k) {
    const double s = k / static_cast<double>(n),
                 a = 2 * std::numbers::pi * (s + 0.1 * std::sin(2 * std::numbers::pi * s));
    const double r = 1 + 0.4 * std::exp(-40 * square(s - 0.6));
    points.t.push_back(s);
    points.values.insert(points.values.end(), {100 + 3 * r * std::cos(a), r * std::sin(a)});
  }
  return points;
}

TEST(FitCurve, EveryMethodPlacesEveryKindOfCurve) {
  CurvePoints helix;
  helix.dimension = 3;
  for (int k = 0; k < 200; ++k) {
    const double t = k / 199.0;
    helix.t.push_back(t);
    helix.values.insert(helix.values.end(), {std::cos(9 * t * t), std::sin(9 * t * t), t});
  }
  const CurvePoints graph = function_points(200, [](double t) { return std::tanh(60 * (t - 0.3)); });
  const CurvePoints round = loop(200);
  for (const CurvePoints* points : {static_cast<const CurvePoints*>(&helix), &graph, &round})
    for (const PlacementMethod& method : placement_methods()) {
      CurveFitOptions options;
      options.method = method.name;
      options.control_points = 12;
      options.evaluations = 200;
      const CurveFitResult fit = fit_curve(*points, options);
      SCOPED_TRACE(std::string(method.name));
      EXPECT_EQ(fit.status, Status::fixed_size);
      EXPECT_EQ(fit.control_points, 12);
      EXPECT_EQ(fit.knots.size(), points->closed ? 11u : 8u);
      EXPECT_EQ(fit.curve.dimension(), points->dimension);
      EXPECT_EQ(fit.curve.knots().first(), 0);
      EXPECT_EQ(fit.curve.knots().last(), 1);
      EXPECT_TRUE(fit.curve.knots().is_clamped());
      // The errors are those of the curve handed out.
      const std::vector<double> values = evaluate(fit.curve, fit.t);
      for (Index k = 0; k < points->size(); ++k) {
        double sum = 0;
        for (int e = 0; e < points->dimension; ++e)
          sum += square(values[k * points->dimension + e] - points->value(k)[e]);
        ASSERT_NEAR(fit.errors[k], std::sqrt(sum), 1e-11);
      }
    }
}

TEST(FitCurve, OptimalIsBestAtEqualKnots) {
  const CurvePoints step = function_points(301, [](double t) { return std::tanh(60 * (t - 0.3)); });
  const CurvePoints chirp = function_points(400, [](double t) {
    return std::sqrt(t * (1 - t)) * std::sin(2 * std::numbers::pi * 1.05 / (t + 0.15));
  });
  for (const CurvePoints& points : {step, chirp, loop(300)}) {
    CurveFitOptions options;
    options.control_points = 16;
    const double best = fit_curve(points, options).error.rms;
    for (const PlacementMethod& method : placement_methods()) {
      options.method = method.name;
      options.evaluations = 500;
      EXPECT_LE(best, fit_curve(points, options).error.rms * 1.001) << method.name;
    }
  }
}

TEST(FitCurve, ClosedCurvesCloseSmoothly) {
  CurveFitOptions options;
  options.control_points = 14;
  for (const char* method : {"uniform", "dominant", "optimal"}) {
    options.method = method;
    const CurveFitResult fit = fit_curve(loop(240), options);
    EXPECT_TRUE(fit.closed);
    // Value and two derivatives of a cubic with a simple knot at the seam.
    const std::vector<double> start = evaluate_derivatives(fit.curve, 0, 2),
                              end = evaluate_derivatives(fit.curve, 1, 2);
    for (int r = 0; r <= 2; ++r)
      for (int e = 0; e < 2; ++e)
        EXPECT_NEAR(start[2 * r + e], end[2 * r + e], 1e-10 * 110 * std::pow(60.0, r)) << method << " " << r;
  }
}

TEST(FitCurve, GivesAClosedSplineBack) {
  // Points of a periodic spline: fitted on its own knots the error is rounding.
  CurveFitOptions options;
  options.knots = std::vector<double>{0.05, 0.2, 0.3, 0.5, 0.7, 0.9};
  const CurveFitResult one = fit_curve(loop(100), options);
  CurvePoints exact = loop(100);
  exact.values = evaluate(one.curve, one.t);
  const CurveFitResult two = fit_curve(exact, options);
  EXPECT_EQ(two.control_points, 6);
  EXPECT_LT(two.error.max, 1e-11);
}

TEST(FitCurve, FindsTheFewestControlPointsOfATolerance) {
  const CurvePoints points = function_points(300, [](double t) { return std::tanh(40 * (t - 0.6)) + t; });
  CurveFitOptions options;
  options.tolerance = {.value = 1e-3};
  for (const char* method : {"optimal", "error-model", "uniform"}) {
    options.method = method;
    const CurveFitResult fit = fit_curve(points, options);
    EXPECT_EQ(fit.status, Status::reached) << method;
    EXPECT_LE(fit.error.max, 1e-3);
    EXPECT_TRUE(fit.reached);
    // The sizes just below were tried and failed.
    CurveFitOptions fewer;
    fewer.method = method;
    fewer.tolerance = options.tolerance;
    fewer.control_points = static_cast<int>(fit.control_points) - 1;
    const CurveFitResult below = fit_curve(points, fewer);
    EXPECT_EQ(below.status, Status::not_reached) << method;
    EXPECT_FALSE(below.reached);
  }
  options.method = "optimal";
  const Index best = fit_curve(points, options).control_points;
  options.method = "uniform";
  EXPECT_LT(best, fit_curve(points, options).control_points / 2);
}

TEST(FitCurve, CorrectedParametersLowerTheError) {
  CurvePoints points = loop(200);
  CurveFitOptions options;
  options.control_points = 12;
  options.method = "error-model";
  const double as_given = fit_curve(points, options).error.rms;
  options.corrections = 20;
  const CurveFitResult corrected = fit_curve(points, options);
  EXPECT_LT(corrected.error.rms, 0.9 * as_given);
  // Errors are then distances to the curve: no nearer place beside the foot.
  for (Index k = 0; k < points.size(); k += 7)
    for (double side : {-1e-4, 1e-4}) {
      double t = corrected.t[k] + side;
      t -= std::floor(t);
      const std::vector<double> at = evaluate(corrected.curve, std::vector<double>{t});
      EXPECT_GE(std::hypot(at[0] - points.value(k)[0], at[1] - points.value(k)[1]),
                corrected.errors[k] * (1 - 1e-3) - 1e-6);
    }
}

TEST(FitCurve, DoesNotDependOnWhereTheDataLies) {
  CurveFitOptions options;
  options.control_points = 10;
  options.method = "dominant";
  CurvePoints points = loop(100);
  const CurveFitResult here = fit_curve(points, options);
  for (std::size_t i = 0; i < points.values.size(); i += 2) points.values[i] += 1024;
  const CurveFitResult there = fit_curve(points, options);
  EXPECT_NEAR(here.error.rms, there.error.rms, 1e-9 * here.error.rms + 1e-12);
}

TEST(FitCurve, StopsWithTheBestSoFar) {
  std::stop_source source;
  source.request_stop();
  Control control;
  control.stop = source.get_token();
  CurveFitOptions options;
  options.tolerance = {.value = 1e-6};
  const CurveFitResult fit = fit_curve(loop(200), options, control);
  EXPECT_EQ(fit.status, Status::stopped);
  EXPECT_GT(fit.curve.size(), 0);
}

TEST(FitCurve, KeepsTheBestAtTheTimeLimit) {
  Control control;
  control.time_limit = 1e-9;  // the first size tried is the last
  CurveFitOptions options;
  options.tolerance = ToleranceRequest{.value = 1e-12};
  const CurveFitResult cut = fit_curve(loop(100), options, control);
  EXPECT_EQ(cut.status, Status::time_limit);
  EXPECT_EQ(cut.tried.size(), 1u);
  EXPECT_EQ(cut.control_points, 4);
  EXPECT_FALSE(cut.reached);
  EXPECT_NE(cut.message.find("time limit"), std::string::npos);
}

TEST(FitCurve, FollowsTheUsersFeatures) {
  // The curve turns at 0.3; the measure is all between 0.7 and 0.8, and does not depend on the map's v.
  const CurvePoints graph = function_points(300, [](double t) { return std::tanh(60 * (t - 0.3)); });
  CurveFitOptions options;
  options.method = "criterion";
  options.control_points = 14;
  for (Index columns : {1, 7}) {
    FeatureMap map{20, columns, std::vector<double>(20 * columns, 1e-3)};
    for (Index c = 14 * columns; c < 16 * columns; ++c) map.f[c] = 1;
    options.user_features = map;
    const CurveFitResult fit = fit_curve(graph, options);
    EXPECT_GE(
        std::count_if(fit.knots.begin(), fit.knots.end(), [](double t) { return t > 0.69 && t < 0.81; }), 8)
        << columns;
  }
  options.user_features.f[3] = -1;
  expect_throw<InvalidInput>([&] { fit_curve(graph, options); }, "the feature measure of cell (0, 3) is -1");
}

TEST(FitCurve, SaysWhereDataIsTooSparse) {
  CurveFitOptions options;
  options.tolerance = {.value = 1e-9};
  options.method = "uniform";
  const CurvePoints wave = function_points(40, [](double t) { return std::sin(25 * t); });
  EXPECT_EQ(fit_curve(wave, options).status, Status::data_too_sparse);
  options.max_control_points = 8;
  const CurveFitResult limited = fit_curve(wave, options);
  EXPECT_EQ(limited.status, Status::limit_reached);
  EXPECT_LE(limited.control_points, 8);
}

TEST(FitCurve, SaysWhereOnlyNoiseIsLeft) {
  CurveFitOptions options;
  options.tolerance = {.value = 1e-4};
  Uniform random(3);
  const CurvePoints noisy =
      function_points(400, [&](double t) { return std::sin(5 * t) + 0.1 * (random() + random() - 1); });
  const CurveFitResult r = fit_curve(noisy, options);
  EXPECT_EQ(r.status, Status::tolerance_below_noise);
  EXPECT_NEAR(r.noise, 0.1 * std::sqrt(1.0 / 6), 0.01);  // the deviation of a sum of two uniform numbers
  EXPECT_LT(r.control_points, 40);
  EXPECT_NE(r.message.find("below the noise of the data"), std::string::npos);
}

TEST(FitCurve, KeepsToItsData) {
  CurveFitOptions options;
  options.tolerance = {.value = 1e-3};
  options.method = "uniform";
  const CurvePoints step = function_points(300, [](double t) { return (t > 0.5) + 0.01 * std::sin(20 * t); });
  const CurveFitResult r = fit_curve(step, options);
  EXPECT_TRUE(r.swings.measured);
  EXPECT_LT(r.swings.beyond_box, 0.2);  // it was 160 times the range
  EXPECT_EQ(r.reached, r.measured <= r.tolerance && !r.swings.swings);
}

TEST(FitCurve, RefusesWhatItCannotFit) {
  const auto refused = [](const CurvePoints& points, const CurveFitOptions& options,
                          const std::string& words) {
    expect_throw<InvalidInput>([&] { fit_curve(points, options); }, words);
  };
  const CurvePoints points = loop(30);
  CurveFitOptions options;
  refused(points, options, "give a tolerance, a number of control points, or knots");
  options.control_points = 31;
  refused(points, options, "30 points are fewer than 31 control points");
  options.control_points = 3;
  refused(points, options, "3 control points: degree 3 needs at least 4");
  options.control_points = 8;
  options.degree = 10;
  refused(points, options, "degree 10: it must be 1 to 9");
  options = {};
  options.knots = std::vector<double>{0.1, 0.5, 0.5, 0.9};
  refused(points, options, "knots of a closed curve increase in [0,1)");
  options = {};
  options.control_points = 8;
  options.method = "best";
  refused(points, options, "no placement method 'best'");
  options.method = "uniform";
  options.corrections = -1;
  refused(points, options, "-1 corrections");
  options.corrections = 1;
  refused(function_points(30, [](double t) { return t; }), options, "cannot be corrected");
  options.corrections = 0;
  CurvePoints bad = points;
  bad.t[3] = 1;
  refused(bad, options, "point 3 has the parameter 1");
  bad = points;
  bad.values[7] = NAN;
  refused(bad, options, "not finite");
  bad = points;
  std::fill(bad.values.begin(), bad.values.end(), 2.0);
  refused(bad, options, "all points are equal");
  options.tolerance = {.value = -1};
  refused(points, options, "must be positive");
}

}  // namespace
}  // namespace knotfit::test
