// The paper's framework: isolines inserted, knots placed anew, knots dropped [Zhang16].
#include <gtest/gtest.h>

#include <algorithm>

#include "knotfit/fit_least_squares.h"
#include "search/searches.h"
#include "support/two_threads.h"
namespace knotfit::test {
namespace {

TEST(Insertion, ReachesTheTolerance) {
  for (const char* name : {"franke", "peaks", "torus", "step"}) {
    const ParameterizedPoints points = synthetic_points(name, 4000);
    const RefineOptions options = by_insertion(5e-3 * synthetic_diagonal(points));
    const RefineResult r = refine_to_tolerance(points, options);
    EXPECT_EQ(r.status, Status::reached) << name;
    expect_consistent(r, points, options);
  }
}

TEST(Insertion, DropsKnotsUntilNoOneCanGo) {
  const ParameterizedPoints points = synthetic_points("franke", 3000);
  const RefineOptions options = by_insertion(5e-3);
  const RefineResult r = refine_to_tolerance(points, options);
  ASSERT_EQ(r.status, Status::reached);
  LeastSquaresOptions fit;
  fit.refinement_steps = 0;
  for (bool v : {false, true})
    for (std::size_t i = 0; i < (v ? r.knots.v : r.knots.u).size(); ++i) {
      InteriorKnots fewer = r.knots;
      auto& line = v ? fewer.v : fewer.u;
      line.erase(line.begin() + static_cast<Index>(i));
      const LeastSquaresResult without =
          fit_least_squares(points, KnotVector::clamped(3, fewer.u), KnotVector::clamped(3, fewer.v), fit);
      EXPECT_GT(without.error.max, 5e-3) << "knot " << i << (v ? " of v" : " of u") << " is not needed";
    }
}

TEST(Insertion, HoldsTheMeasureAskedFor) {
  const ParameterizedPoints points = synthetic_points("peaks", 4000);
  RefineOptions options = by_insertion(5e-3 * synthetic_diagonal(points));
  Index before = 0;
  for (ErrorMeasure measure : {ErrorMeasure::rms, ErrorMeasure::percentile, ErrorMeasure::max}) {
    options.tolerance.measure = measure;
    options.tolerance.share = 0.95;
    const RefineResult r = refine_to_tolerance(points, options);
    EXPECT_EQ(r.status, Status::reached);
    expect_consistent(r, points, options);
    EXPECT_GE(control_points(r), before);
    before = control_points(r);
  }
}

TEST(Insertion, WorksForDegreesApartAndInSpace) {
  const ParameterizedPoints points = synthetic_points("torus", 4000);
  RefineOptions options = by_insertion(1e-2 * synthetic_diagonal(points));
  for (const auto& [m, n] : {std::pair{2, 4}, {5, 1}}) {
    options.degree_u = m;
    options.degree_v = n;
    const RefineResult r = refine_to_tolerance(points, options);
    EXPECT_EQ(r.status, Status::reached) << m << "x" << n;
    expect_consistent(r, points, options);
  }
}

TEST(Insertion, FollowsTheFeatureMeasure) {
  const ParameterizedPoints points = synthetic_points("peaks", 3000);
  RefineOptions options = by_insertion(2e-2 * synthetic_diagonal(points));
  options.feature = FeatureMeasure::curvature;
  expect_consistent(refine_to_tolerance(points, options), points, options);
  // A user's map of unequal counts, finer or coarser than the library's own.
  for (const auto& [size_u, size_v] : {std::pair<Index, Index>{10, 37}, {301, 3}, {1, 1}}) {
    options.user_features =
        FeatureMap{size_u, size_v, std::vector<double>(static_cast<std::size_t>(size_u * size_v), 1.0)};
    const RefineResult r = refine_to_tolerance(points, options);
    EXPECT_EQ(r.status, Status::reached);
    expect_consistent(r, points, options);
  }
}

TEST(Insertion, DoesNotDependOnTheThreads) {
  const ParameterizedPoints points = synthetic_points("step", 5000);
  const RefineOptions options = by_insertion(1e-2 * synthetic_diagonal(points));
  const auto [one, two] = on_one_and_two_threads([&] { return refine_to_tolerance(points, options); });
  EXPECT_EQ(one.surface, two.surface);
  EXPECT_EQ(one.fits, two.fits);
}

}  // namespace
}  // namespace knotfit::test
