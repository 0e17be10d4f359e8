#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/threads.h"
#include "knotfit/verify.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
#include "verify/de_boor.h"
namespace knotfit {
namespace {

using test::expect_throw;

// A surface near the truth without a fit: control points from the truth at the Greville abscissae. It is wrong
// by about h^2 |f''| / 6, so the net's size sets how far.
Surface near_truth(const std::string& name, int spans, int degree = 3) {
  const KnotVector knots = KnotVector::uniform(degree, spans - 1);
  std::vector<double> net;
  for (double u : knots.greville())
    for (double v : knots.greville())
      for (double x : test::synthetic_value(name, u, v)) net.push_back(x);
  return {knots, knots, test::synthetic_dimension(name), net};
}

double true_max(const Surface& s, const std::string& name) {
  double worst = 0;
  std::vector<double> at(static_cast<std::size_t>(s.dimension()));
  for (int i = 0; i <= 400; ++i)
    for (int j = 0; j <= 400; ++j) {
      const double u = i / 400.0, v = j / 400.0;
      verify::de_boor(s, u, v, at);
      worst = std::max(worst, verify::distance(at, test::synthetic_value(name, u, v)));
    }
  return worst;
}

Surface flat() {
  return {KnotVector::uniform(1, 0), KnotVector::uniform(1, 0), 1, {0, 0, 0, 0}};
}

void same(const BetweenReport& a, const BetweenReport& b) {
  EXPECT_EQ(a.between, b.between);
  EXPECT_EQ(a.bound, b.bound);
  EXPECT_EQ(a.thin, b.thin);
  EXPECT_EQ(a.worst_u, b.worst_u);
  EXPECT_EQ(a.promised, b.promised);
  EXPECT_EQ(a.noise, b.noise);
  ASSERT_EQ(a.thin_places.size(), b.thin_places.size());
  for (std::size_t i = 0; i < a.thin_places.size(); ++i)
    EXPECT_EQ(a.thin_places[i].error_bar, b.thin_places[i].error_bar);
}

// The measure follows the true error over the whole domain, which it cannot see: it climbs to the tops from the largest of
// 4000 places, so it is hardly below the largest of 160 000.
TEST(Between, FollowsTheTrueErrorOverTheDomain) {
  for (const std::string name : {"franke", "peaks", "torus"})
    for (int spans : {12, 50}) {
      const ParameterizedPoints points = test::synthetic_points(name);
      const double tolerance = 1e-3 * test::synthetic_diagonal(points);
      const Surface surface = near_truth(name, spans);
      const BetweenReport report = measure_between(surface, points, tolerance);
      const double truth = true_max(surface, name);
      ASSERT_TRUE(report.measured);
      EXPECT_GT(report.between.value(), 0.985 * truth) << name << spans;
      EXPECT_LT(report.between.value(), 1.02 * truth) << name << spans;
      EXPECT_GE(report.bound.value(), report.between.value());
      EXPECT_EQ(report.noise, 0);
      EXPECT_LT(report.thin, 0.002);
      EXPECT_GE(report.places, 4000);
      EXPECT_LE(report.places, 4500);  // cells that hold few points
      EXPECT_EQ(report.promised + static_cast<Index>(report.thin_places.size()), report.places);
      std::vector<double> at(static_cast<std::size_t>(points.dimension));
      verify::de_boor(surface, report.worst_u, report.worst_v, at);
      EXPECT_NEAR(verify::distance(at, test::synthetic_value(name, report.worst_u, report.worst_v)),
                  report.between.value(), 0.05 * tolerance);
    }
}

// A surface through every point of a grid with a wave between them: no residual sees it.
TEST(Between, SeesAWaveThatVanishesAtEveryPoint) {
  const int cells = 40;
  ParameterizedPoints grid;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      grid.uv.insert(grid.uv.end(), {i / double(cells), j / double(cells)});
      grid.values.push_back(0);
    }
  const double wave = 0.01;
  std::vector<double> knots;
  for (int k = 1; k < 2 * cells; ++k) knots.push_back(k / (2.0 * cells));
  const KnotVector half = KnotVector::clamped(1, knots);
  std::vector<double> net;
  for (int i = 0; i <= 2 * cells; ++i)
    for (int j = 0; j <= 2 * cells; ++j) net.push_back(i % 2 == 1 && j % 2 == 1 ? wave : 0);
  const Surface surface(half, half, 1, net);
  for (double e : recheck_errors(surface, grid)) ASSERT_LT(e, 1e-12);
  const BetweenReport report = measure_between(surface, grid, 1e-3);
  EXPECT_GT(report.between.value(), 0.9 * wave);
  EXPECT_LE(report.between.value(), wave * (1 + 1e-12));
  EXPECT_EQ(report.thin, 0);
}

// One bump of a fine net in a gap of 1.5 spacings between scattered points.
TEST(Between, SeesABumpInAGap) {
  ParameterizedPoints points;
  const ParameterizedPoints all = test::synthetic_points("franke");
  for (Index k = 0; k < all.size(); ++k)
    if (std::hypot(all.u(k) - 0.61, all.v(k) - 0.37) > 0.015)
      points.uv.insert(points.uv.end(), {all.u(k), all.v(k)}), points.values.push_back(0);
  const int spans = 400;
  const KnotVector knots = KnotVector::uniform(3, spans - 1);
  std::vector<double> net(static_cast<std::size_t>(knots.size() * knots.size()), 0);
  const Index i = std::lround(0.61 * spans + 1), j = std::lround(0.37 * spans + 1);
  for (Index a = -2; a <= 2; ++a)
    for (Index b = -2; b <= 2; ++b) net[(i + a) * knots.size() + j + b] = 1;
  const Surface surface(knots, knots, 1, net);
  for (double e : recheck_errors(surface, points)) ASSERT_LT(e, 1e-12);
  const BetweenReport report = measure_between(surface, points, 0.01);
  EXPECT_GT(report.between.value(), 0.5);
  EXPECT_NEAR(report.worst_u, 0.61, 0.01);
  EXPECT_NEAR(report.worst_v, 0.37, 0.01);
}

TEST(Between, PromisesNothingInAHoleAndSaysHowLargeItIs) {
  ParameterizedPoints points;
  test::Uniform random(1);
  const double radius = std::sqrt(0.2 / std::numbers::pi);  // 20 % of the domain
  while (points.size() < 10000) {
    const double u = random(), v = random();
    if (std::hypot(u - 0.5, v - 0.5) < radius) continue;
    points.uv.insert(points.uv.end(), {u, v}), points.values.push_back(test::franke(u, v));
  }
  const double tolerance = 1e-3 * test::synthetic_diagonal(points);
  // A surface that is far off in the middle of the hole only.
  Surface surface = near_truth("franke", 100);
  std::vector<double> net = surface.net();
  const Index n = surface.size_v();
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      if (std::hypot(static_cast<double>(i) / double(n) - 0.5, static_cast<double>(j) / double(n) - 0.5) <
          0.1)
        net[i * n + j] += 1;
  surface = Surface(surface.knots_u(), surface.knots_v(), 1, net);
  const BetweenReport report = measure_between(surface, points, tolerance);
  // 16 % was said for a hole of 20 % when the method was chosen [METHOD 5.3], since near its rim the data still reaches in.
  EXPECT_GT(report.thin, 0.13);
  EXPECT_LT(report.thin, 0.20);
  EXPECT_LT(report.between.value(), tolerance);
  for (const ThinPlace& p : report.thin_places) EXPECT_LT(std::hypot(p.u - 0.5, p.v - 0.5), radius + 0.03);
  EXPECT_TRUE(std::ranges::all_of(
      report.thin_places, [&](const ThinPlace& p) { return p.gap > 0.35 || p.error_bar > tolerance / 2; }));
}

TEST(Between, TakesGridsOfAnyShape) {
  struct Case {
    int rows, columns;
    double least_thin, most_thin;
  };
  // A square grid; one twice as dense in one direction; rows so dense that a stencil sees a single one; three
  // and two lines only, where the polynomials lose rank; two by two points.
  for (const Case& c : {Case{100, 100, 0, 0}, Case{70, 140, 0, 0}, Case{10, 1000, 0.9, 1}, Case{3, 30, 0, 1},
                        Case{2, 50, 0, 1}, Case{2, 2, 1, 1}}) {
    ParameterizedPoints grid;
    for (int i = 0; i < c.rows; ++i)
      for (int j = 0; j < c.columns; ++j) {
        const double u = i / (c.rows - 1.0), v = j / (c.columns - 1.0);
        grid.uv.insert(grid.uv.end(), {u, v}), grid.values.push_back(test::franke(u, v));
      }
    const double tolerance = 1e-3 * test::synthetic_diagonal(grid);
    const Surface surface = near_truth("franke", 100);
    const BetweenReport report = measure_between(surface, grid, tolerance);
    EXPECT_TRUE(report.measured);
    EXPECT_GE(report.thin, c.least_thin) << c.rows;
    EXPECT_LE(report.thin, c.most_thin) << c.rows;
    if (c.rows > 10) {
      EXPECT_LT(report.between.value(), 1.02 * true_max(surface, "franke"));
    }
    EXPECT_EQ(report.bound.has_value(), report.promised > 0);
    EXPECT_TRUE(std::isfinite(report.bound.value_or(0)));
  }
}

TEST(Between, KnowsPolynomialDataExactly) {
  ParameterizedPoints points = test::synthetic_points("franke", 5000);
  for (Index k = 0; k < points.size(); ++k)
    points.values[k] = 3 - points.u(k) + 2 * points.u(k) * points.v(k);
  const KnotVector one = KnotVector::uniform(1, 0);
  const BetweenReport exact = measure_between({one, one, 1, {3, 3, 2, 4}}, points, 1e-6);
  EXPECT_LT(exact.bound.value(), 1e-11);
  EXPECT_EQ(exact.thin, 0);
  EXPECT_EQ(exact.noise, 0);
  const BetweenReport off = measure_between({one, one, 1, {3, 3, 2, 4.5}}, points, 1e-6);
  EXPECT_NEAR(off.between.value(), 0.5, 1e-9);  // at the corner
}

TEST(Between, MeasuresFlatData) {
  ParameterizedPoints points = test::synthetic_points("franke", 500);
  std::fill(points.values.begin(), points.values.end(), 0.0);
  const BetweenReport report = measure_between(flat(), points, 1e-6);
  EXPECT_EQ(report.between, 0);
  EXPECT_EQ(report.bound, 0);
  std::fill(points.values.begin(), points.values.end(), 7.0);
  EXPECT_EQ(measure_between(flat(), points, 1e-6).between, 7);
}

TEST(Between, DoesNotDependOnTheScaleOfTheValues) {
  for (const std::string name : {"ridge", "torus"}) {
    ParameterizedPoints points = test::synthetic_points(name, 3000);
    test::Uniform random(3);
    const double tolerance = 1e-3 * test::synthetic_diagonal(points);
    for (double& z : points.values) z += 0.1 * tolerance * random.normal();
    const Surface surface = near_truth(name, 60);
    const BetweenReport one = measure_between(surface, points, tolerance);
    ASSERT_GT(one.promised, 0);
    for (double scale : {0x1p-150}) {
      ParameterizedPoints scaled = points;
      std::vector<double> net = surface.net();
      for (double& z : scaled.values) z *= scale;
      for (double& z : net) z *= scale;
      const BetweenReport other = measure_between(
          {surface.knots_u(), surface.knots_v(), surface.dimension(), net}, scaled, tolerance * scale);
      EXPECT_EQ(other.between, one.between.value() * scale);
      EXPECT_EQ(other.bound, one.bound.value() * scale);
      EXPECT_EQ(other.noise, one.noise * scale);
      EXPECT_EQ(other.promised, one.promised);
    }
  }
}

TEST(Between, FindsNoiseAndMeasuresTheSurfaceBehindIt) {
  ParameterizedPoints points = test::synthetic_points("franke");
  const double tolerance = 1e-3 * test::synthetic_diagonal(points);
  test::Uniform random(778);
  for (double& z : points.values) z += 0.2 * tolerance * random.normal();
  const Surface surface = near_truth("franke", 100);
  const BetweenReport report = measure_between(surface, points, tolerance);
  EXPECT_NEAR(report.noise / tolerance, 0.2, 0.015);
  const double truth = true_max(surface, "franke");
  EXPECT_GT(report.between.value(), 0.8 * truth);
  EXPECT_LT(report.between.value(), truth + tolerance);
  // Noise far below the tolerance is none: the values are interpolated.
  EXPECT_EQ(measure_between(surface, points, 20 * tolerance).noise, 0);
}

// In error-model coordinates fewer places are beyond promise on steps [METHOD 5.3].
TEST(Between, MappedMetricMakesMoreOfStepsPromised) {
  const ParameterizedPoints points = test::synthetic_points("step");
  const double tolerance = 1e-3 * test::synthetic_diagonal(points);
  const Surface surface = near_truth("step", 100);
  const BetweenReport plain = measure_between(surface, points, tolerance);
  BetweenOptions options;  // knots that crowd at the steps, as an error model's do
  for (int k = 1; k < 40; ++k) {
    const double s = k / 40.0;
    auto crowd = [&](double at) {  // equal shares of 1 + 15 within 0.05 of the step
      const double a = at - 0.05, b = at + 0.05, total = 1 + 1.5, left = s * total;
      return left < a ? left : left < a + 16 * (b - a) ? a + (left - a) / 16 : left - 15 * (b - a);
    };
    options.metric_u.push_back(crowd(0.3)), options.metric_v.push_back(crowd(0.7));
  }
  const BetweenReport mapped = measure_between(surface, points, tolerance, options);
  EXPECT_GT(plain.thin, 0.04);  // 6.9 % in the trial
  EXPECT_LT(plain.thin, 0.10);
  EXPECT_LT(mapped.thin, 0.4 * plain.thin);
  EXPECT_GT(mapped.between.value(), 0.8 * plain.between.value());
}

TEST(Between, HasNoPromiseFromFewPoints) {
  for (Index n : {1, 3, 8}) {
    const BetweenReport report = measure_between(flat(), test::synthetic_points("franke", n), 0.1);
    EXPECT_TRUE(report.measured);
    EXPECT_EQ(report.promised, 0);
    EXPECT_EQ(report.thin, 1);
    EXPECT_FALSE(report.between.has_value());  // not measured, and not 0
    EXPECT_FALSE(report.bound.has_value());
    EXPECT_EQ(report.thin_places.front().error_bar, INFINITY);
  }
}

TEST(Between, MergesRepeatedPoints) {
  const ParameterizedPoints once = test::synthetic_points("franke", 2000);
  ParameterizedPoints twice = once;
  twice.uv.insert(twice.uv.end(), once.uv.begin(), once.uv.end());
  twice.values.insert(twice.values.end(), once.values.begin(), once.values.end());
  const Surface surface = near_truth("franke", 50);
  same(measure_between(surface, once, 1e-3), measure_between(surface, twice, 1e-3));
}

TEST(Between, SameBitsForOneAndTwoThreads) {
  const ParameterizedPoints points = test::synthetic_points("torus", 20000);
  const Surface surface = near_truth("torus", 30);
  BetweenOptions options;
  options.metric_u = {0.2, 0.4, 0.6};
  set_thread_count(1);
  const BetweenReport one = measure_between(surface, points, 1e-6, options);
  set_thread_count(2);
  same(measure_between(surface, points, 1e-6, options), one);
  set_thread_count(0);
}

TEST(Between, TakesTheNumberOfPlacesAsked) {
  const ParameterizedPoints points = test::synthetic_points("franke", 2000);
  BetweenOptions options;
  options.random_places = 0;
  options.gap_places = 30;
  BetweenReport report = measure_between(flat(), points, 1, options);
  EXPECT_EQ(report.places, 30);
  EXPECT_EQ(report.thin, 0);
  options.gap_places = 0;
  report = measure_between(flat(), points, 1, options);
  EXPECT_TRUE(report.measured);
  EXPECT_EQ(report.places, 0);
  options.random_places = 50;
  EXPECT_EQ(measure_between(flat(), points, 1, options).places, 50);
}

TEST(Between, SeesASwingInASlitBetweenTwoKnots) {
  // A bump in a slit of 2e-4 that holds hardly a point: no random place falls into it.
  const ParameterizedPoints points = test::synthetic_points("franke", 10000);
  const KnotVector u = KnotVector::clamped(3, std::vector<double>{0.4999, 0.4999, 0.5, 0.5001, 0.5001});
  const KnotVector v = KnotVector::clamped(3, {});
  std::vector<double> net(static_cast<std::size_t>(u.size() * v.size()), 0.0);
  for (Index j = 0; j < v.size(); ++j) net[static_cast<std::size_t>(4 * v.size() + j)] = 50;
  ParameterizedPoints zero = points;
  std::fill(zero.values.begin(), zero.values.end(), 0.0);
  for (Index k = 0; k < points.size(); ++k) zero.values[k] = 1e-6 * points.value(k)[0];
  const Surface surface(u, v, 1, net);
  EXPECT_GT(measure_between(surface, zero, 1e-3).between.value(), 1);
  BetweenOptions without;
  without.cell_places = 0;
  EXPECT_LT(measure_between(surface, zero, 1e-3, without).between.value(), 1);
}

TEST(Between, StopsWhenAskedAndReportsProgress) {
  const ParameterizedPoints points = test::synthetic_points("franke", 5000);
  std::stop_source source;
  Control control;
  control.stop = source.get_token();
  std::vector<double> fractions;
  control.progress = [&](const Progress& p) {
    EXPECT_EQ(p.stage, "between");
    fractions.push_back(p.fraction);
    if (fractions.size() == 3) source.request_stop();
  };
  EXPECT_FALSE(measure_between(flat(), points, 1, {}, control).measured);
  EXPECT_EQ(fractions.size(), 3u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_FALSE(measure_between(flat(), points, 1, {}, control).measured);  // stopped before it began
  EXPECT_EQ(fractions.size(), 3u);
  Control limited;
  limited.time_limit = 1e-9;
  EXPECT_FALSE(measure_between(flat(), points, 1, {}, limited).measured);
}

TEST(Between, RefusesWhatItCannotMeasure) {
  const ParameterizedPoints points = test::synthetic_points("franke", 100);
  for (double tolerance : {0.0, -1.0, std::nan(""), double(INFINITY)})
    expect_throw<InvalidInput>([&] { measure_between(flat(), points, tolerance); },
                               "must be positive and finite");
  expect_throw<InvalidInput>([&] { measure_between(Surface(), points, 1); }, "control net is empty");
  expect_throw<InvalidInput>([&] { measure_between(flat(), test::synthetic_points("torus", 9), 1); },
                             "dimension 1 cannot be measured against points of dimension 3");
  expect_throw<InvalidInput>([&] { measure_between(flat(), ParameterizedPoints(), 1); }, "no points");
  BetweenOptions options;
  options.gap_places = -1;
  expect_throw<InvalidInput>([&] { measure_between(flat(), points, 1, options); }, "none may be negative");
  options.gap_places = 1;
  options.cell_places = -1;
  expect_throw<InvalidInput>([&] { measure_between(flat(), points, 1, options); }, "-1 cell places");
  options.cell_places = 500;
  options.metric_u = {0.5, 0.2};
  expect_throw<InvalidInput>([&] { measure_between(flat(), points, 1, options); }, "");
}

}  // namespace
}  // namespace knotfit
