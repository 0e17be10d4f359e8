// What every method of the table promises.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "knotfit/exceptions.h"
#include "knotfit/place.h"
#include "knotfit/threads.h"
#include "place/shares.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

enum class Layout { uniform, clustered, grid, lines, repeated };

ParameterizedPoints arranged(Random& random, Layout layout, int n, int dimension) {
  ParameterizedPoints points;
  points.dimension = dimension;
  const int side = std::max(2, static_cast<int>(std::sqrt(n)));
  for (int k = 0; k < (layout == Layout::grid ? side * side : n); ++k) {
    double u = random.unit(), v = random.unit();
    switch (layout) {
      case Layout::clustered:
        if (k % 30 != 0) {
          u = 0.7 + 1e-3 * u;
          v = 0.2 + 1e-6 * v;
        }
        break;
      case Layout::grid:
        u = (k / side) / (side - 1.0);
        v = (k % side) / (side - 1.0);
        break;
      case Layout::lines:
        u = std::round(3 * u) / 3;
        break;
      case Layout::repeated:
        u = v = k % 2;
        break;
      case Layout::uniform:
        break;
    }
    points.uv.insert(points.uv.end(), {u, v});
    for (int d = 0; d < dimension; ++d)
      points.values.push_back(random.uniform(-1, 1) + std::tanh(50 * (u - 0.4)));
  }
  return points;
}

/// Simple knots, or, where `ties` allow it, knots up to the multiplicity that a knot vector may have.
void expect_valid(const Placement& placement, int p, int q, bool ties = false) {
  for (const auto& [line, count] : {std::pair{&placement.knots.u, p}, {&placement.knots.v, q}}) {
    ASSERT_EQ(static_cast<int>(line->size()), count);
    double before = 0;
    for (double x : *line) {
      if (ties) {
        ASSERT_GE(x, before);
        ASSERT_GT(x, 0);
      } else {
        ASSERT_GT(x, before);  // NaN fails too
      }
      before = x;
    }
    ASSERT_LT(before, 1);
  }
  EXPECT_NE(placement.status, PlacementStatus::not_run);
  EXPECT_TRUE(std::isfinite(placement.criterion));
  EXPECT_GE(placement.criterion, 0);
  EXPECT_GE(placement.fits, 0);
}

bool slow(const PlacementMethod& method) {
  return method.name == "optimal" || method.name == "full-lspia" || method.name == "sparse" ||
         method.name == "conjugate-gradient" || method.name.starts_with("evolutionary");
}

TEST(Methods, AreNamedOnceAndDescribed) {
  std::set<std::string_view> names;
  for (const PlacementMethod& method : placement_methods()) {
    EXPECT_TRUE(names.insert(method.name).second) << method.name;
    EXPECT_FALSE(method.summary.empty());
    EXPECT_FALSE(method.source.empty());
    EXPECT_EQ(method.summary.find('\n'), std::string_view::npos);
  }
  for (const char* name : {"error-model", "criterion", "uniform", "quantile"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Methods, OnesThatNeedRowsSayWhatTheyMadeOfScatteredPoints) {
  Random random(3);
  const ParameterizedPoints scattered = arranged(random, Layout::uniform, 200, 1);
  PlacementOptions options;
  options.interior_u = options.interior_v = 3;
  options.evaluations = 60;
  for (const PlacementMethod& method : placement_methods()) {
    const Placement placement = place_knots(method.name, scattered, options);
    const bool rows = std::any_of(placement.notes.begin(), placement.notes.end(),
                                  [](const std::string& n) { return n.find("rows") != std::string::npos; });
    EXPECT_EQ(rows, method.traits.needs_rows) << method.name;
  }
}

RC_GTEST_PROP(Methods, GiveIncreasingKnotsOfTheCountsAsked, ()) {
  Random random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000000)));
  const auto layout =
      *rc::gen::element(Layout::uniform, Layout::clustered, Layout::grid, Layout::lines, Layout::repeated);
  const int n = *rc::gen::inRange(40, 200), dimension = *rc::gen::element(1, 2, 3);
  PlacementOptions options;
  options.interior_u = *rc::gen::inRange(0, 7);
  options.interior_v = *rc::gen::inRange(0, 7);
  options.degree_u = *rc::gen::inRange(1, 6);
  options.degree_v = *rc::gen::inRange(1, 6);
  const ParameterizedPoints points = arranged(random, layout, n, dimension);
  for (const PlacementMethod& method : placement_methods()) {
    if (slow(method) && random.integer(0, 9) > 0) continue;  // hundreds of fits
    options.evaluations = 100;
    SCOPED_TRACE(std::string(method.name));
    expect_valid(place_knots(method.name, points, options), options.interior_u, options.interior_v,
                 method.name == "optimal");
    RC_ASSERT(!testing::Test::HasFailure());
  }
}

TEST(Methods, DoNotDependOnTheThreads) {
  Random random;
  const ParameterizedPoints points = synthetic_points("ridge", 9000);
  PlacementOptions options;
  options.interior_u = options.interior_v = 6;
  options.evaluations = 50;
  for (const PlacementMethod& method : placement_methods()) {
    set_thread_count(1);
    const Placement one = place_knots(method.name, points, options);
    set_thread_count(2);
    const Placement two = place_knots(method.name, points, options);
    EXPECT_EQ(one.knots, two.knots) << method.name;
    EXPECT_EQ(one.fits, two.fits) << method.name;
    EXPECT_EQ(one.criterion, two.criterion) << method.name;
  }
  set_thread_count(0);
}

TEST(Methods, StopWhereAskedWithKnotsThatServe) {
  const ParameterizedPoints points = synthetic_points("franke", 2000);
  std::stop_source source;
  source.request_stop();
  Control control;
  control.stop = source.get_token();
  for (const PlacementMethod& method : placement_methods()) {
    SCOPED_TRACE(std::string(method.name));
    expect_valid(place_knots(method.name, points, {}, control), 8, 8, method.name == "optimal");
  }
  EXPECT_EQ(place_knots("error-model", points, {}, control).status, PlacementStatus::stopped);
}

TEST(Methods, AnUnknownOneListsThoseThereAre) {
  const ParameterizedPoints points = synthetic_points("franke", 200);
  expect_throw<InvalidInput>([&] { place_knots("dominent", points); },
                             "there is no placement method 'dominent'; there are ");
  for (const PlacementMethod& method : placement_methods())
    expect_throw<InvalidInput>([&] { place_knots("", points); }, std::string(method.name));
}

TEST(Methods, RefuseOptionsOutOfRange) {
  const ParameterizedPoints points = synthetic_points("franke", 200);
  auto expect_refused = [&](PlacementOptions options, const std::string& words) {
    for (const PlacementMethod& method : placement_methods())
      expect_throw<InvalidInput>([&] { place_knots(method.name, points, options); }, words);
  };
  PlacementOptions options;
  options.interior_u = -1;
  expect_refused(options, "-1 x 8 interior knots: neither may be negative");
  options = {};
  options.interior_v = -3;
  expect_refused(options, "8 x -3 interior knots");
  options = {};
  options.degree_u = 0;
  expect_refused(options, "degree 0 is outside [1, 9]");
  options = {};
  options.degree_v = 10;
  expect_refused(options, "degree 10 is outside [1, 9]");
  options = {};
  options.rounds = -1;
  expect_refused(options, "-1 rounds and 100 sweeps: neither may be negative");
  options = {};
  options.sweeps = -1;
  expect_refused(options, "12 rounds and -1 sweeps");
  options = {};
  options.smoothing = -1;
  expect_refused(options, "the smoothing floor");
  options = {};
  options.user_features = FeatureMap{2, 2, {1, 2, -3, 4}};
  expect_refused(options, "the feature measure of cell (1, 0) is -3");
}

TEST(Methods, RefuseBadPoints) {
  ParameterizedPoints points = synthetic_points("franke", 200);
  points.values[17] = std::numeric_limits<double>::quiet_NaN();
  for (const PlacementMethod& method : placement_methods())
    expect_throw<InvalidInput>([&] { place_knots(method.name, points); },
                               "point 17 has a value that is not finite");
}

TEST(CriterionMethod, FollowsTheUsersFeatures) {
  const ParameterizedPoints points = synthetic_points("step", 3000);
  PlacementOptions options;
  options.user_features = FeatureMap{10, 10, std::vector<double>(100, 1.0)};
  const Placement even = place_knots("criterion", points, options);
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(even.knots.u[i], (i + 1) / 9.0, 1e-4);
  EXPECT_EQ(even.fits, 0);
  for (Index j = 0; j < 10; ++j) options.user_features.f[20 + j] = 100;  // u in [0.2, 0.3)
  const Placement drawn = place_knots("criterion", points, options);
  const auto inside = std::count_if(drawn.knots.u.begin(), drawn.knots.u.end(),
                                    [](double x) { return x > 0.19 && x < 0.31; });
  EXPECT_GE(inside, 7);
}

TEST(CriterionMethod, ReportsTheEnergyOfItsKnots) {
  const ParameterizedPoints points = synthetic_points("peaks", 4000);
  for (FeatureMeasure measure : {FeatureMeasure::hessian, FeatureMeasure::curvature,
                                 FeatureMeasure::derivative, FeatureMeasure::residual}) {
    PlacementOptions options;
    options.feature = measure;
    const Placement placement = place_knots("criterion", points, options);
    EXPECT_GT(placement.criterion, 0);
    EXPECT_LE(placement.criterion, placement.criterion_start * (1 + 1e-12));
    EXPECT_EQ(placement.fits, 1);
  }
}

}  // namespace
}  // namespace knotfit::test
