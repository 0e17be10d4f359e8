// How a search ends, and that the best surface so far comes back whatever the end.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "knotfit/verify.h"
#include "search/searches.h"
namespace knotfit::test {
namespace {

class Statuses : public testing::TestWithParam<RefineRoute> {
 protected:
  RefineOptions options(double tolerance) const {
    RefineOptions o = to_max_error(tolerance);
    o.route = GetParam();
    return o;
  }
};

TEST_P(Statuses, ReachedWhereTheToleranceHolds) {
  const ParameterizedPoints points = synthetic_points("franke", 2000);
  const RefineOptions o = options(1e-2);
  const RefineResult r = refine_to_tolerance(points, o);
  EXPECT_EQ(r.status, Status::reached);
  expect_consistent(r, points, o);
}

TEST_P(Statuses, DataTooSparseWhereHalfThePointsAreNotEnough) {
  const ParameterizedPoints points = synthetic_points("ridge", 300);
  const RefineOptions o = options(1e-6);
  const RefineResult r = refine_to_tolerance(points, o);
  EXPECT_EQ(r.status, Status::data_too_sparse);
  expect_consistent(r, points, o);
  for (const SizeTried& t : r.tried) EXPECT_LE(t.size_u * t.size_v, 150);
}

TEST_P(Statuses, LimitReachedByTheCallersControlPoints) {
  const ParameterizedPoints points = synthetic_points("ridge", 3000);
  for (Index most : {16, 21, 50, 100}) {
    RefineOptions o = options(1e-6);
    o.max_control_points = most;
    const RefineResult r = refine_to_tolerance(points, o);
    EXPECT_EQ(r.status, Status::limit_reached);
    expect_consistent(r, points, o);
    for (const SizeTried& t : r.tried) EXPECT_LE(t.size_u * t.size_v, most);
    if (most >= 50) {
      EXPECT_GE(control_points(r), most / 2) << "the best stays far below the limit";
    }
  }
}

TEST_P(Statuses, LimitBeyondThePointsIsNoLimit) {
  const ParameterizedPoints points = synthetic_points("ridge", 300);
  RefineOptions o = options(1e-6);
  o.max_control_points = 1000000;
  const RefineResult r = refine_to_tolerance(points, o);
  EXPECT_EQ(r.status, Status::data_too_sparse);
  for (const SizeTried& t : r.tried) EXPECT_LE(t.size_u * t.size_v, 300);
}

TEST_P(Statuses, LimitOnAStripOfFewLines) {
  ParameterizedPoints points;
  Uniform random(3);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 200; ++j) {
      points.uv.insert(points.uv.end(), {i / 3.0, j / 199.0});
      points.values.push_back(random());
    }
  RefineOptions o = options(1e-6);
  o.max_control_points = 16;
  const RefineResult r = refine_to_tolerance(points, o);
  EXPECT_EQ(r.status, Status::limit_reached);
  expect_consistent(r, points, o);
  for (const SizeTried& t : r.tried) EXPECT_LE(t.size_u * t.size_v, 16);
}

TEST_P(Statuses, EndsOnAGridWhoseLinesAreAllUsed) {
  // 12 x 12 lines, no limit below 12 x 12 functions, and a tolerance that placed knots do not meet.
  ParameterizedPoints points;
  Uniform random(7);
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) {
      points.uv.insert(points.uv.end(), {i / 11.0, j / 11.0});
      points.values.push_back(random());
    }
  for (Index most : {144, 100000}) {
    RefineOptions o = options(1e-9);
    o.max_control_points = most;
    const RefineResult r = refine_to_tolerance(points, o);
    EXPECT_NE(r.status, Status::not_run);
    expect_consistent(r, points, o);
  }
}

TEST_P(Statuses, LimitReachedByTheBudgetOfFits) {
  const ParameterizedPoints points = synthetic_points("ridge", 3000);
  for (long fits : {1, 20, 60}) {
    RefineOptions o = options(1e-4);
    o.max_fits = fits;
    const RefineResult r = refine_to_tolerance(points, o);
    EXPECT_EQ(r.status, Status::limit_reached) << fits;
    expect_consistent(r, points, o);
    EXPECT_LE(r.fits, fits + 25) << "one placement more at most";
  }
}

TEST_P(Statuses, ToleranceBelowNoise) {
  for (std::uint64_t seed : {1, 2, 3}) {
    ParameterizedPoints points = synthetic_points("franke", 5000, seed);
    const double sigma = 0.01;
    Uniform random(seed + 100);
    for (double& z : points.values) z += sigma * random.normal();
    RefineOptions o = options(sigma);
    o.noise = estimate_noise(points);
    EXPECT_NEAR(o.noise, sigma, 0.3 * sigma);
    const RefineResult r = refine_to_tolerance(points, o);
    EXPECT_EQ(r.status, Status::tolerance_below_noise) << "seed " << seed;
    expect_consistent(r, points, o);
  }
}

TEST_P(Statuses, ATolerancePastTheNoiseIsReached) {
  ParameterizedPoints points = synthetic_points("franke", 5000);
  const double sigma = 0.01;
  Uniform random(11);
  for (double& z : points.values) z += sigma * random.normal();
  RefineOptions o = options(5.5 * sigma);
  o.noise = estimate_noise(points);
  const RefineResult r = refine_to_tolerance(points, o);
  EXPECT_EQ(r.status, Status::reached);
  EXPECT_LT(control_points(r), 200);
}

TEST_P(Statuses, StoppedReturnsTheBestSoFar) {
  const ParameterizedPoints points = synthetic_points("ridge", 3000);
  const RefineOptions o = options(1e-3);
  for (int after : {0, 1, 3, 8}) {
    std::stop_source source;
    Control control;
    control.stop = source.get_token();
    int calls = 0;
    double best = INFINITY;
    if (after == 0) source.request_stop();
    control.progress = [&](const Progress& p) {
      best = p.error;
      if (++calls == after) source.request_stop();
    };
    const RefineResult r = refine_to_tolerance(points, o, control);
    EXPECT_EQ(r.status, Status::stopped) << "after " << after;
    expect_consistent(r, points, o);
    EXPECT_EQ(r.error, best);
  }
}

TEST_P(Statuses, TimeLimitReturnsTheBestSoFar) {
  const ParameterizedPoints points = synthetic_points("ridge", 20000);
  const RefineOptions o = options(1e-4);
  Control control;
  control.time_limit = 0.05;
  const auto start = std::chrono::steady_clock::now();
  const RefineResult r = refine_to_tolerance(points, o, control);
  EXPECT_EQ(r.status, Status::time_limit);
  expect_consistent(r, points, o);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 20);
}

TEST_P(Statuses, TheBestKeepsToTheData) {
  // Nets near the number of points swing between them: a smaller error there is no better surface.
  const ParameterizedPoints points = synthetic_points("peaks", 400);
  const RefineOptions o = options(1e-6);
  const RefineResult r = refine_to_tolerance(points, o);
  const SwingReport swings =
      measure_swings(r.surface, points, recheck_errors(r.surface, points), o.tolerance.value);
  EXPECT_FALSE(swings.swings) << swings.largest << " beyond the box " << swings.beyond_box;
  EXPECT_FALSE(r.swings);
  EXPECT_NEAR(r.error, evaluated_error(r.surface, points, o.tolerance), 1e-9);
}

TEST_P(Statuses, NoneOfTheSizesThatHoldIsSmallerThanTheBest) {
  const ParameterizedPoints points = synthetic_points("peaks", 3000);
  const RefineOptions o = options(5e-3 * synthetic_diagonal(points));
  const RefineResult r = refine_to_tolerance(points, o);
  ASSERT_EQ(r.status, Status::reached);
  for (const SizeTried& t : r.tried)
    if (t.holds) {
      EXPECT_LE(control_points(r), t.size_u * t.size_v);
    }
}

INSTANTIATE_TEST_SUITE_P(Routes, Statuses, testing::Values(RefineRoute::search, RefineRoute::insert),
                         [](const auto& at) {
                           return at.param == RefineRoute::search ? "search" : "insert";
                         });

}  // namespace
}  // namespace knotfit::test
