#include "knotfit/fit_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "knotfit/closest_point.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using Points = std::vector<double>;

/// A turned wave over the unit square. \param bump  height of a narrow bump that few points see
Points sheet(int count, double bump = 0) {
  Random random(5);
  Points p;
  for (int k = 0; k < count; ++k) {
    const double x = random.unit(), y = random.unit();
    const double z = 0.2 * std::sin(3 * x) * std::cos(2 * y) +
                     bump * std::exp(-(std::pow(x - 0.62, 2) + std::pow(y - 0.41, 2)) / 1e-3);
    p.insert(p.end(), {0.8 * x - 0.6 * z, y, 0.6 * x + 0.8 * z});
  }
  return p;
}

CloudSource source(const Points& points) {
  return {points,
          [](std::span<const double> some, std::span<const Index>) { return parameterize_cloud(some); }};
}

FitOptions to_tolerance(double value, ErrorMeasure measure = ErrorMeasure::max, double share = 1) {
  FitOptions options;
  options.tolerance = ToleranceRequest{.value = value, .measure = measure, .share = share};
  return options;
}

CloudFit fit(const Points& points, Index most, const FitOptions& options) {
  const CloudSource cloud = source(points);
  return fit_cloud(cloud, most, map_sample(cloud, most), options);
}

/// Every point of the cloud once, with its own coordinates, and the error that the surface has there.
void expect_all_judged(const CloudFit& fitted, const Points& points) {
  const MeshFit& f = fitted.fit;
  const auto n = static_cast<Index>(points.size()) / 3;
  ASSERT_EQ(f.points.size(), n);
  ASSERT_EQ(static_cast<Index>(f.result.errors.size()), n);
  std::vector<Index> numbers = f.points.source;
  std::sort(numbers.begin(), numbers.end());
  for (Index k = 0; k < n; ++k) ASSERT_EQ(numbers[k], k + 1);
  for (Index k = 0; k < n; k += 97) {
    const double* p = &points[3 * (f.points.source[k] - 1)];
    for (int c = 0; c < 3; ++c) EXPECT_EQ(f.points.value(k)[c], p[c]);
    EXPECT_NEAR(closest_point(f.result.surface, {p[0], p[1], p[2]}).distance, f.result.errors[k], 1e-12);
  }
  EXPECT_EQ(f.result.error.max, *std::max_element(f.result.errors.begin(), f.result.errors.end()));
}

TEST(FitCloud, ASampleIsFittedAndAllPointsAreJudged) {
  const Points points = sheet(12000);
  FitOptions options = to_tolerance(0.2);  // %
  options.tolerance->relative = true;
  const CloudFit f = fit(points, 1500, options);
  expect_all_judged(f, points);
  const FitResult& r = f.fit.result;
  EXPECT_EQ(r.status, Status::reached);
  EXPECT_TRUE(r.reached);
  EXPECT_LE(r.error.max, r.tolerance);
  EXPECT_EQ(r.measured, r.error.max);
  EXPECT_EQ(r.sample, f.map.sample);
  EXPECT_LE(f.map.sample, 1500 + 200);
  EXPECT_EQ(f.map.points, 12000);
  EXPECT_LE(r.surface.control_point_count(), 100);
}

TEST(FitCloud, WhatTheSampleDoesNotSeeJoinsIt) {
  const Points points =
      sheet(12000, 0.03);  // a bump of 40 points or so, of which a sample of 250 has one or none
  const CloudFit f = fit(points, 250, to_tolerance(0.012));
  expect_all_judged(f, points);
  EXPECT_TRUE(f.fit.result.reached) << f.fit.result.message;
  EXPECT_GT(f.rounds, 1);
  EXPECT_GT(f.map.sample, map_sample(source(points), 250).sample);
}

TEST(FitCloud, APercentileIsOfAllPoints) {
  const Points points = sheet(12000, 0.02);
  const CloudFit f = fit(points, 600, to_tolerance(0.001, ErrorMeasure::percentile, 0.99));
  expect_all_judged(f, points);
  const FitResult& r = f.fit.result;
  EXPECT_EQ(r.tolerance, 0.001);
  EXPECT_EQ(r.measured, measured_error(r.errors, r.asked));
  EXPECT_EQ(r.reached, r.measured <= 0.001);
  EXPECT_TRUE(r.reached) << r.message;
}

TEST(FitCloud, AnRmsTightensUntilAllPointsHoldIt) {
  const Points points = sheet(12000, 0.03);
  const CloudFit f = fit(points, 250, to_tolerance(0.0015, ErrorMeasure::rms));
  expect_all_judged(f, points);
  EXPECT_EQ(f.fit.result.reached, f.fit.result.error.rms <= 0.0015);
  EXPECT_TRUE(f.fit.result.reached) << f.fit.result.message;
}

TEST(FitCloud, AFixedSizeIsFittedOnce) {
  const Points points = sheet(8000, 0.05);
  FitOptions options;
  options.control_points_u = 7;
  options.control_points_v = 6;
  const CloudFit f = fit(points, 500, options);
  expect_all_judged(f, points);
  EXPECT_EQ(f.rounds, 1);
  EXPECT_EQ(f.fit.result.status, Status::fixed_size);
  EXPECT_EQ(f.fit.result.surface.control_point_count(), 42);
}

TEST(FitCloud, AToleranceOutOfReachIsNotReached) {
  Points points = sheet(8000);
  Random random(9);
  for (double& x : points) x += 1e-2 * (random.unit() - 0.5);
  FitOptions options = to_tolerance(1e-3);
  options.max_control_points = 100;
  const CloudFit f = fit(points, 500, options);
  expect_all_judged(f, points);
  EXPECT_FALSE(f.fit.result.reached);
  EXPECT_NE(f.fit.result.status, Status::reached);
  EXPECT_GT(f.fit.result.measured, 1e-3);
}

TEST(MapSample, NumbersAreThoseOfTheCloud) {
  const Points points = sheet(5000);
  const std::vector<Index> also{17, 4999};
  const CloudMap map = map_sample(source(points), 300, also);
  EXPECT_EQ(map.points, 5000);
  EXPECT_GE(map.sample, 100);
  EXPECT_LE(map.sample, 302);
  std::vector<Index> numbers;
  for (Index v = 0; v < map.mesh.vertex_count(); ++v) {
    const Index number = map.mesh.vertex_line[v];
    if (number == 0) continue;  // it closes a hole
    numbers.push_back(number);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(map.mesh.vertex(v)[c], points[3 * (number - 1) + c]);
  }
  for (const Index k : also) EXPECT_NE(std::find(numbers.begin(), numbers.end(), k + 1), numbers.end());
}

TEST(MapSample, AllPointsAreNoSample) {
  const Points points = sheet(300);
  EXPECT_EQ(map_sample(source(points), 300).sample, 0);
}

TEST(MapSample, RefusesWhatIsNoCloud) {
  Points points = sheet(100);
  expect_throw<InvalidInput>([&] { map_sample(source(points), 3); }, "at least 4");
  const std::vector<Index> beyond{100};
  expect_throw<InvalidInput>([&] { map_sample(source(points), 50, beyond); }, "no point 100");
  points[7] = NAN;
  expect_throw<InvalidInput>([&] { map_sample(source(points), 50); }, "point 3 (from 1)");
  points.pop_back();
  expect_throw<InvalidInput>([&] { map_sample(source(points), 50); }, "299 coordinates");
}

}  // namespace
}  // namespace knotfit::test
