#include "search/whole_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "data/sample.h"
#include "knotfit/refine.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(WholeData, MeasuresASamplesSurfaceAtEveryPoint) {
  const ParameterizedPoints all = synthetic_points("franke", 30000, 1), few = stratified_sample(all, 3000);
  FitProblem whole(all, 3, 3), sampled(few, 3, 3);
  ASSERT_TRUE(sampled.solve({{0.3, 0.6}, {0.4, 0.7}}));
  WholeData data(whole, {.value = 1e-3});
  const FitProblem& measured = data.measure(sampled);
  EXPECT_EQ(measured.net(), sampled.net());
  EXPECT_EQ(measured.errors().size(), 30000u);
  EXPECT_GT(measured.max(), sampled.max());  // the sample misses the worst
}

TEST(WholeData, LetsTheWorstPointOfEachRegionJoin) {
  const ParameterizedPoints all = synthetic_points("franke", 30000, 1);
  FitProblem whole(all, 3, 3);
  const ParameterizedPoints few = stratified_sample(all, 3000);
  FitProblem sampled(few, 3, 3);
  ASSERT_TRUE(sampled.solve({{0.3, 0.6}, {0.4, 0.7}}));
  WholeData data(whole, {.value = 1e-3});
  const std::vector<double> errors = data.measure(sampled).errors();
  JoinedPoints joined(few);
  const Index count = data.join_worst(joined);
  EXPECT_GT(count, 100);
  EXPECT_LE(count, 300);
  ASSERT_EQ(joined.points().size(), few.size() + count);
  // The worst of all is among them, every one is beyond the tolerance, and no two lie in one cell.
  const double largest = *std::max_element(errors.begin(), errors.end());
  std::set<int> cells;
  double found = 0;
  for (Index k = few.size(); k < joined.points().size(); ++k) {
    const double u = joined.points().u(k), v = joined.points().v(k);
    cells.insert(static_cast<int>(u * 32) * 32 + static_cast<int>(v * 32));
    for (Index i = 0; i < all.size(); ++i)
      if (all.u(i) == u && all.v(i) == v) {
        EXPECT_GT(errors[i], 1e-3);
        found = std::max(found, errors[i]);
      }
  }
  EXPECT_EQ(found, largest);
  EXPECT_EQ(static_cast<Index>(cells.size()), count);
}

TEST(WholeData, LetsNothingJoinASurfaceThatHolds) {
  const ParameterizedPoints all = synthetic_points("franke", 5000, 1);
  FitProblem whole(all, 3, 3), same(all, 3, 3);
  ASSERT_TRUE(same.solve({{0.5}, {0.5}}));
  WholeData data(whole, {.value = 10});
  data.measure(same);
  JoinedPoints joined(all);
  EXPECT_EQ(data.join_worst(joined), 0);
}

// A sample's surface holds at all points or is not called reached, with whatever measure.
TEST(Engine, OfASampleHoldsAtEveryPointByEveryMeasure) {
  const ParameterizedPoints all = synthetic_points("franke", 30000, 2);
  for (const Tolerance& tolerance :
       {Tolerance{.value = 5e-3, .measure = ErrorMeasure::max},
        Tolerance{.value = 3e-3, .measure = ErrorMeasure::rms},
        Tolerance{.value = 5e-3, .measure = ErrorMeasure::percentile, .share = 0.99}}) {
    RefineOptions options;
    options.tolerance = tolerance;
    options.effort = tolerance.measure == ErrorMeasure::max ? Effort::balanced : Effort::fast;
    options.engine = Engine::sample;
    const RefineResult sampled = refine_to_tolerance(all, options);
    options.engine = Engine::points;
    const RefineResult whole = refine_to_tolerance(all, options);
    ASSERT_EQ(sampled.status, Status::reached);
    EXPECT_GT(sampled.sample, 15000);
    EXPECT_EQ(whole.sample, 0);
    FitProblem problem(all, 3, 3);
    problem.evaluate(sampled.knots, std::vector<double>(sampled.surface.net()));
    EXPECT_LE(problem.measured(tolerance), tolerance.value);
    EXPECT_LE(sampled.surface.control_point_count(), whole.surface.control_point_count() * 11 / 10);
  }
}

// A spike that a sample hardly sees is met, too.
TEST(Engine, OfASampleMeetsWhatTheSampleDoesNotSee) {
  ParameterizedPoints all = synthetic_points("franke", 60000, 3);
  for (Index k = 0; k < all.size(); ++k) {
    const double du = all.u(k) - 0.3137, dv = all.v(k) - 0.7123;
    all.values[k] += 0.3 * std::exp(-(du * du + dv * dv) / (2 * 0.02 * 0.02));
  }
  RefineOptions options;
  options.tolerance.value = 0.02;
  options.effort = Effort::fast;
  options.engine = Engine::sample;
  const RefineResult result = refine_to_tolerance(all, options);
  ASSERT_EQ(result.status, Status::reached);
  FitProblem problem(all, 3, 3);
  problem.evaluate(result.knots, std::vector<double>(result.surface.net()));
  EXPECT_LE(problem.max(), 0.02);
}

TEST(Engine, IsNoMatterOfFewPoints) {
  const ParameterizedPoints few = synthetic_points("franke", 2000, 1);
  RefineOptions options;
  options.tolerance.value = 0.01;
  const RefineResult automatic = refine_to_tolerance(few, options);
  options.engine = Engine::sample;
  const RefineResult sampled = refine_to_tolerance(few, options);
  EXPECT_EQ(sampled.sample, 0);
  EXPECT_EQ(sampled.surface.net(), automatic.surface.net());
}

}  // namespace
}  // namespace knotfit::test
