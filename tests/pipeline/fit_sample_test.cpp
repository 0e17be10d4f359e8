#include "knotfit/fit_sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "knotfit/closest_point.h"
#include "knotfit/exceptions.h"
#include "parameterize/mesh_support.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using Points = std::vector<double>;

/// A turned wave over the unit square. \param bump  height of a narrow bump that few points see
Points scattered(int count, double bump = 0) {
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

SampleSource source(const Points& points) {
  return cloud_source(
      points, [](std::span<const double> some, std::span<const Index>) { return parameterize_cloud(some); });
}

FitOptions to_tolerance(double value, ErrorMeasure measure = ErrorMeasure::max, double share = 1) {
  FitOptions options;
  options.tolerance = ToleranceRequest{.value = value, .measure = measure, .share = share};
  return options;
}

SampleFit fit(const Points& points, Index most, const FitOptions& options) {
  const SampleSource cloud = source(points);
  return fit_sample(cloud, most, map_sample(cloud, most), options);
}

/// Every point of the cloud once, with its own coordinates, and the error that the surface has there.
void expect_all_judged(const SampleFit& fitted, const Points& points) {
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

TEST(FitSample, ASampleIsFittedAndAllPointsAreJudged) {
  const Points points = scattered(12000);
  FitOptions options = to_tolerance(0.2);  // %
  options.tolerance->relative = true;
  const SampleFit f = fit(points, 1500, options);
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

TEST(FitSample, WhatTheSampleDoesNotSeeJoinsIt) {
  const Points points =
      scattered(12000, 0.03);  // a bump of 40 points or so, of which a sample of 250 has one or none
  const SampleFit f = fit(points, 250, to_tolerance(0.012));
  expect_all_judged(f, points);
  EXPECT_TRUE(f.fit.result.reached) << f.fit.result.message;
  EXPECT_GT(f.rounds, 1);
  EXPECT_GT(f.map.sample, map_sample(source(points), 250).sample);
}

TEST(FitSample, APercentileIsOfAllPoints) {
  const Points points = scattered(12000, 0.02);
  const SampleFit f = fit(points, 600, to_tolerance(0.001, ErrorMeasure::percentile, 0.99));
  expect_all_judged(f, points);
  const FitResult& r = f.fit.result;
  EXPECT_EQ(r.tolerance, 0.001);
  EXPECT_EQ(r.measured, measured_error(r.errors, r.asked));
  EXPECT_EQ(r.reached, r.measured <= 0.001);
  EXPECT_TRUE(r.reached) << r.message;
}

TEST(FitSample, AnRmsTightensUntilAllPointsHoldIt) {
  const Points points = scattered(12000, 0.03);
  const SampleFit f = fit(points, 250, to_tolerance(0.0015, ErrorMeasure::rms));
  expect_all_judged(f, points);
  EXPECT_EQ(f.fit.result.reached, f.fit.result.error.rms <= 0.0015);
  EXPECT_TRUE(f.fit.result.reached) << f.fit.result.message;
}

TEST(FitSample, AFixedSizeIsFittedOnce) {
  const Points points = scattered(8000, 0.05);
  FitOptions options;
  options.control_points_u = 7;
  options.control_points_v = 6;
  const SampleFit f = fit(points, 500, options);
  expect_all_judged(f, points);
  EXPECT_EQ(f.rounds, 1);
  EXPECT_EQ(f.fit.result.status, Status::fixed_size);
  EXPECT_EQ(f.fit.result.surface.control_point_count(), 42);
}

TEST(FitSample, AToleranceOutOfReachIsNotReached) {
  Points points = scattered(8000);
  Random random(9);
  for (double& x : points) x += 1e-2 * (random.unit() - 0.5);
  FitOptions options = to_tolerance(1e-3);
  options.max_control_points = 100;
  const SampleFit f = fit(points, 500, options);
  expect_all_judged(f, points);
  EXPECT_FALSE(f.fit.result.reached);
  EXPECT_NE(f.fit.result.status, Status::reached);
  EXPECT_GT(f.fit.result.measured, 1e-3);
}

/// A wavy sheet of n x n cells with a bump between the vertices of any sample.
Mesh fine_sheet(int n) {
  return sheet(n, n, 1, 1, [](double x, double y) {
    return 0.2 * std::sin(3 * x) * std::cos(2 * y) +
           0.03 * std::exp(-(std::pow(x - 0.62, 2) + std::pow(y - 0.41, 2)) / 1e-3);
  });
}

/// Without the faces within 0.1 of the middle.
Mesh mesh_without_middle(Mesh mesh) {
  std::erase_if(mesh.faces, [&](const std::array<std::int32_t, 3>& f) {
    return std::any_of(f.begin(), f.end(), [&](std::int32_t v) {
      return std::hypot(mesh.vertex(v)[0] - 0.5, mesh.vertex(v)[1] - 0.5) < 0.1;
    });
  });
  return mesh;
}

MeshMap plain_map(const Mesh& mesh) {
  return parameterize_mesh(mesh, {.corners = CornerRule::sharpest, .omega = 0, .newton = false});
}

TEST(FitSample, OfAMeshEveryVertexIsJudgedAndTheDistanceBackIsToAllOfIt) {
  const Mesh mesh = fine_sheet(90);
  const SampleSource source = mesh_source(mesh, plain_map);
  const CloudMap map = map_sample(source, 500);
  EXPECT_LT(map.sample, 500 + 4 * 90 + 100);  // the border stays
  EXPECT_NO_THROW(require_disk(map.mesh));
  const SampleFit f = fit_sample(source, 500, map, to_tolerance(0.006));
  expect_all_judged(f, mesh.vertices);
  EXPECT_TRUE(f.fit.result.reached) << f.fit.result.message;
  const DistanceSummary back = mesh_distances(f.fit.result.surface, mesh, {}, 300);
  EXPECT_NEAR(f.fit.to_mesh.max, back.max, 0.02 * back.max);
}

TEST(FitSample, OfAMeshVerticesOfVirtualFacesAloneAreNoData) {
  Mesh mesh = fine_sheet(40);
  RepairedMesh repaired = repair(mesh_without_middle(mesh), {.fill_holes = true});
  const SampleSource source = mesh_source(repaired.mesh, plain_map);
  EXPECT_EQ(static_cast<Index>(source.points.size()) / 3, repaired.mesh.vertex_count() - 1);
  FitOptions options;
  options.control_points_u = options.control_points_v = 6;
  const SampleFit f = fit_sample(source, 200, map_sample(source, 200), options);
  EXPECT_EQ(f.fit.points.size(), repaired.mesh.vertex_count() - 1);
}

TEST(MapSample, NumbersAreThoseOfTheCloud) {
  const Points points = scattered(5000);
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
  const Points points = scattered(300);
  EXPECT_EQ(map_sample(source(points), 300).sample, 0);
}

TEST(MapSample, RefusesWhatIsNoCloud) {
  Points points = scattered(100);
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
