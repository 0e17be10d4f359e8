// The size search [METHOD 4.1].
#include <gtest/gtest.h>

#include <algorithm>

#include "knotfit/exceptions.h"
#include "search/searches.h"
#include "support/two_threads.h"
namespace knotfit::test {
namespace {

TEST(SizeSearch, HoldsTheMeasureAskedFor) {
  const ParameterizedPoints points = synthetic_points("peaks", 4000);
  const double tolerance = 2e-3 * synthetic_diagonal(points);
  RefineOptions options = to_max_error(tolerance);
  const RefineResult most = refine_to_tolerance(points, options);
  options.tolerance.measure = ErrorMeasure::percentile;
  options.tolerance.share = 0.95;
  const RefineResult share = refine_to_tolerance(points, options);
  options.tolerance.measure = ErrorMeasure::rms;
  const RefineResult rms = refine_to_tolerance(points, options);
  for (const auto& [result, measure] :
       {std::pair{&most, ErrorMeasure::max}, {&share, ErrorMeasure::percentile}, {&rms, ErrorMeasure::rms}}) {
    options.tolerance.measure = measure;
    EXPECT_EQ(result->status, Status::reached);
    expect_consistent(*result, points, options);
  }
  // The max holds all of them, and the RMS is the weakest of the three.
  EXPECT_LT(control_points(share), control_points(most));
  EXPECT_LT(control_points(rms), control_points(share));
}

TEST(SizeSearch, OneSpikeDoesNotCostAPercentileAnything) {
  ParameterizedPoints points = synthetic_points("franke", 4000);
  RefineOptions options = to_max_error(2e-3 * synthetic_diagonal(points));
  options.tolerance.measure = ErrorMeasure::percentile;
  options.tolerance.share = 0.995;
  const RefineResult clean = refine_to_tolerance(points, options);
  points.values[1234] += 25 * options.tolerance.value;
  const RefineResult spiked = refine_to_tolerance(points, options);
  EXPECT_EQ(spiked.status, Status::reached);
  EXPECT_LE(static_cast<double>(control_points(spiked)), 1.1 * static_cast<double>(control_points(clean)));
}

TEST(SizeSearch, ALooserToleranceNeedsNoMore) {
  for (const char* name : {"franke", "peaks", "torus"}) {
    const ParameterizedPoints points = synthetic_points(name, 4000);
    double before = 0;
    for (double relative : {1e-1, 3e-2, 1e-2, 3e-3, 1e-3}) {
      const RefineOptions options = to_max_error(relative * synthetic_diagonal(points));
      const RefineResult r = refine_to_tolerance(points, options);
      EXPECT_EQ(r.status, Status::reached);
      const double now = static_cast<double>(control_points(r));
      EXPECT_GE(1.1 * now, before) << name << " at " << relative;  // placement is no global optimum
      before = now;
    }
  }
}

TEST(SizeSearch, GrowsWithTheRatioOfSpansGiven) {
  const ParameterizedPoints points = synthetic_points("peaks", 4000);
  RefineOptions options = to_max_error(2e-3 * synthetic_diagonal(points));
  const double given[] = {4, 0.25, 1, 1000, 1e-3};
  const std::pair<int, int> first[] = {{8, 2}, {2, 8}, {4, 4}, {9, 2}, {2, 9}};  // held between 1/5 and 5
  for (int k = 0; k < 5; ++k) {
    options.span_ratio = given[k];
    const RefineResult r = refine_to_tolerance(points, options);
    EXPECT_EQ(r.tried.front().size_u, first[k].first + 3) << given[k];
    EXPECT_EQ(r.tried.front().size_v, first[k].second + 3) << given[k];
    expect_consistent(r, points, options);
  }
}

TEST(SizeSearch, TakesOnePatchWhereThatHolds) {
  ParameterizedPoints points = synthetic_points("franke", 500);
  for (Index k = 0; k < points.size(); ++k) points.values[k] = points.u(k) * points.u(k) - points.v(k);
  for (const RefineOptions& options : {to_max_error(1e-6), by_insertion(1e-6)}) {
    const RefineResult r = refine_to_tolerance(points, options);
    EXPECT_EQ(r.status, Status::reached);
    EXPECT_EQ(control_points(r), 16);
  }
}

TEST(SizeSearch, DirectionsGetWhatTheyNeed) {
  // Ten waves along u, a line along v.
  ParameterizedPoints points = synthetic_points("franke", 4000);
  for (Index k = 0; k < points.size(); ++k)
    points.values[k] = std::sin(20 * points.u(k)) + 0.01 * points.v(k);
  const RefineOptions options = to_max_error(1e-2);
  const RefineResult r = refine_to_tolerance(points, options);
  EXPECT_EQ(r.status, Status::reached);
  EXPECT_LE(r.surface.size_v(), 5);
  EXPECT_GE(r.surface.size_u(), 10);
}

TEST(SizeSearch, TransposedDataTransposesTheSurface) {
  const ParameterizedPoints points = synthetic_points("ridge", 4000);
  ParameterizedPoints turned = points;
  for (Index k = 0; k < points.size(); ++k) std::swap(turned.uv[2 * k], turned.uv[2 * k + 1]);
  const RefineOptions options = to_max_error(1e-2 * synthetic_diagonal(points));
  const RefineResult a = refine_to_tolerance(points, options), b = refine_to_tolerance(turned, options);
  EXPECT_NEAR(static_cast<double>(control_points(a)), static_cast<double>(control_points(b)),
              0.1 * static_cast<double>(control_points(a)));  // ties between sizes go to one direction
}

TEST(SizeSearch, WorksForEveryDegreeApartInUAndV) {
  const ParameterizedPoints points = synthetic_points("franke", 3000);
  for (const auto& [m, n] : {std::pair{1, 1}, {1, 3}, {2, 5}, {4, 2}, {6, 6}, {9, 9}}) {
    RefineOptions options = to_max_error(2e-2);
    options.degree_u = m;
    options.degree_v = n;
    const RefineResult r = refine_to_tolerance(points, options);
    EXPECT_EQ(r.status, Status::reached) << m << "x" << n;
    expect_consistent(r, points, options);
  }
}

TEST(SizeSearch, WorksInAnyDimension) {
  for (int dimension : {1, 2, 3, 5}) {
    ParameterizedPoints points = synthetic_points("franke", 3000);
    points.dimension = dimension;
    points.values.clear();
    for (Index k = 0; k < points.size(); ++k)
      for (int d = 0; d < dimension; ++d)
        points.values.push_back(d == 0 ? points.u(k)
                                       // another shape in every component
                                       : franke(0.5 * points.u(k) + 0.1 * d, points.v(k)) * d);
    const RefineOptions options = to_max_error(2e-2);
    const RefineResult r = refine_to_tolerance(points, options);
    EXPECT_EQ(r.status, Status::reached);
    expect_consistent(r, points, options);
  }
}

TEST(SizeSearch, WorksWithWeights) {
  ParameterizedPoints points = synthetic_points("franke", 3000);
  Uniform random(5);
  for (Index k = 0; k < points.size(); ++k) points.weights.push_back(0.5 + random());
  const RefineOptions options = to_max_error(1e-2);
  const RefineResult r = refine_to_tolerance(points, options);
  EXPECT_EQ(r.status, Status::reached);
  expect_consistent(r, points, options);
}

TEST(SizeSearch, WorksWithEveryPlacedMethod) {
  const ParameterizedPoints points = synthetic_points("torus", 4000);
  for (const PlacementMethod& method : placement_methods()) {
    if (method.name == "optimal") continue;
    if (method.name.starts_with("evolutionary")) continue;  // thousands of fits a size: for one size
    const RefineOptions options = to_max_error(5e-3 * synthetic_diagonal(points), std::string(method.name));
    const RefineResult r = refine_to_tolerance(points, options);
    EXPECT_EQ(r.status, Status::reached) << method.name;
    expect_consistent(r, points, options);
  }
}

TEST(SizeSearch, WorksOnGridsAndStripsOfFewLines) {
  for (const auto& [size_u, size_v] : {std::pair{60, 80}, {2, 400}, {400, 3}, {5, 200}}) {
    ParameterizedPoints points;
    for (int i = 0; i < size_u; ++i)
      for (int j = 0; j < size_v; ++j) {
        const double u = i / (size_u - 1.0), v = j / (size_v - 1.0);
        points.uv.insert(points.uv.end(), {u, v});
        points.values.push_back(franke(u, v));
      }
    for (const RefineOptions& options : {to_max_error(1e-2), by_insertion(1e-2)}) {
      const RefineResult r = refine_to_tolerance(points, options);
      EXPECT_EQ(r.status, Status::reached) << size_u << " x " << size_v;
      expect_consistent(r, points, options);
    }
  }
}

TEST(SizeSearch, DoesNotDependOnTheThreads) {
  const ParameterizedPoints points = synthetic_points("ridge", 9000);
  const RefineOptions options = to_max_error(5e-3 * synthetic_diagonal(points));
  const auto [one, two] = on_one_and_two_threads([&] { return refine_to_tolerance(points, options); });
  EXPECT_EQ(one.surface, two.surface);
  EXPECT_EQ(one.error, two.error);
  EXPECT_EQ(one.fits, two.fits);
  EXPECT_EQ(one.tried.size(), two.tried.size());
}

TEST(SizeSearch, ReportsItsProgress) {
  const ParameterizedPoints points = synthetic_points("franke", 3000);
  const RefineOptions options = to_max_error(1e-2);
  long calls = 0, fits = 0;
  double error = INFINITY;
  Control control;
  control.progress = [&](const Progress& p) {
    ++calls;
    EXPECT_FALSE(p.stage.empty());
    EXPECT_EQ(p.tolerance, 1e-2);
    EXPECT_GE(p.fits, fits);
    EXPECT_GE(p.size_u, 4);
    EXPECT_GE(p.size_v, 4);
    if (error > 1e-2) {
      EXPECT_LE(p.error, error);  // the best so far, until it holds
    }
    fits = p.fits;
    error = p.error;
  };
  const RefineResult r = refine_to_tolerance(points, options, control);
  EXPECT_GT(calls, 3);
  EXPECT_EQ(error, r.error);
}

TEST(SizeSearch, GivesTheMetricOfItsFineModel) {
  const ParameterizedPoints points = synthetic_points("franke", 3000);
  const RefineResult r = refine_to_tolerance(points, to_max_error(1e-2));
  EXPECT_GE(r.metric.u.size(), 7u);
  EXPECT_TRUE(std::is_sorted(r.metric.u.begin(), r.metric.u.end()));
}

}  // namespace
}  // namespace knotfit::test
