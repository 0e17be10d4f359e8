// The known behaviour of methods that iterate: their errors fall, what they remove is not missed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/fit_least_squares.h"
#include "knotfit/place.h"
#include "place/free_net.h"
#include "place/full_lspia.h"
#include "place/knot_spacings.h"
#include "place/shares.h"
#include "support/expect_gradient.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

double rms(const ParameterizedPoints& points, const InteriorKnots& knots) {
  return fit_least_squares(points, KnotVector::clamped(3, knots.u), KnotVector::clamped(3, knots.v))
      .error.rms;
}

FitProblem plain_problem(const ParameterizedPoints& points) {
  LeastSquaresOptions options;
  options.refinement_steps = 0;
  options.estimate_condition = false;
  options.use_grid = false;
  return FitProblem(points, 3, 3, options);
}

TEST(FreeNet, IsTheResidualsAndTheirDerivatives) {
  ParameterizedPoints points = synthetic_points("torus", 300);
  Random random(7);
  for (Index k = 0; k < points.size(); ++k) points.weights.push_back(random.uniform(0.5, 2));
  const InteriorKnots knots{{0.2, 0.35, 0.6}, {0.3, 0.7}};
  const Axis u(3, knots.u), v(2, knots.v);
  const std::vector<double> net = random_numbers(random, u.functions() * v.functions() * 3);
  const FreeNet at = free_net(points, u, v, net, true);

  // The slow way: evaluate the surface.
  const Surface s(u.knots(), v.knots(), 3, net);
  const std::vector<double> values = evaluate(s, points.uv);
  double phi = 0;
  for (Index k = 0; k < points.size(); ++k)
    for (int d = 0; d < 3; ++d) phi += points.weight(k) * square(values[3 * k + d] - points.value(k)[d]);
  EXPECT_NEAR(at.phi, phi, 1e-10 * phi);

  expect_gradient([&](const std::vector<double>& x) { return free_net(points, u, v, x, false).phi; }, net,
                  at.by_net);
  // phi is a spline of the knots only between the points: differences stay away from them.
  std::vector<double> k(knots.u);
  k.insert(k.end(), knots.v.begin(), knots.v.end());
  const auto moved = [&](const std::vector<double>& x) {
    return free_net(points, Axis(3, std::span(x).first(3)), Axis(2, std::span(x).last(2)), net, false).phi;
  };
  for (std::size_t i = 0; i < k.size(); ++i) {
    std::vector<double> after = k, before = k;
    after[i] += 1e-6;
    before[i] -= 1e-6;
    EXPECT_NEAR(at.by_knots[i], (moved(after) - moved(before)) / 2e-6,
                1e-4 * std::abs(at.by_knots[i]) + 1e-4);
  }
  // By log-spacings: the chain rule.
  const std::vector<double> by = by_log_spacings(knots, at.by_knots);
  ASSERT_EQ(by.size(), 7u);
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<double> step(4, 0.0);
    const auto along = [&](double x) {
      step[i] = x;
      const std::vector<double> line = KnotSpacings(knots.u).moved(step.data(), 1e-6).knots();
      return free_net(points, Axis(3, line), v, net, false).phi;
    };
    EXPECT_NEAR(by[i], (along(1e-6) - along(-1e-6)) / 2e-6, 1e-4 * std::abs(by[i]) + 1e-4) << i;
  }
}

TEST(FreeNet, RowSumsAreThoseOfTheNormalMatrix) {
  const ParameterizedPoints points = synthetic_points("franke", 500);
  const Axis u(3, std::vector<double>{0.5}), v(3);
  const std::vector<double> sums = net_row_sums(points, u, v);
  EXPECT_NEAR(std::accumulate(sums.begin(), sums.end(), 0.0), 500, 1e-9);
  for (double x : sums) EXPECT_GT(x, 0);
}

TEST(FreeNet, DoesNotDependOnTheChunks) {
  const ParameterizedPoints points = synthetic_points("ridge", 9000);
  const Axis u(3, uniform_knots(5)), v(3, uniform_knots(4));
  const std::vector<double> net(u.functions() * v.functions(), 0.5);
  const FreeNet a = free_net(points, u, v, net, true), b = free_net(points, u, v, net, true);
  EXPECT_EQ(a.phi, b.phi);
  EXPECT_EQ(a.by_net, b.by_net);
  EXPECT_EQ(a.by_knots, b.by_knots);
}

TEST(FullLspia, ErrorFallsEachRound) {
  for (const char* name : {"franke", "ridge", "torus"}) {
    const ParameterizedPoints points = synthetic_points(name, 3000);
    FitProblem problem = plain_problem(points);
    InteriorKnots knots{uniform_knots(8), uniform_knots(8)};
    FullLspiaOptions options;
    options.rounds = 15;
    const std::vector<double> history = full_lspia(problem, knots, options);
    ASSERT_GE(history.size(), 5u) << name;
    for (std::size_t i = 1; i < history.size(); ++i)
      EXPECT_LE(history[i], history[i - 1]) << name << " round " << i;
    EXPECT_LT(history.back(), history.front()) << name;
    // The last phi belongs to control points that are not yet the least squares' of the last knots.
    ASSERT_TRUE(problem.solve(knots));
    EXPECT_LE(problem.phi(), history.back() * (1 + 1e-6)) << name;
  }
}

TEST(FullLspia, BeatsItsStart) {
  const ParameterizedPoints points = synthetic_points("peaks", 4000);
  EXPECT_LT(rms(points, place_knots("full-lspia", points).knots),
            rms(points, place_knots("averaging", points).knots));
}

TEST(Prune, KeepsTheToleranceAndLosesKnots) {
  const ParameterizedPoints points = synthetic_points("franke", 3000);
  const InteriorKnots dense{uniform_knots(9), uniform_knots(9)};
  for (const ErrorMeasure measure : {ErrorMeasure::max, ErrorMeasure::rms}) {
    const Tolerance tolerance{measure == ErrorMeasure::max ? 0.02 : 0.003, measure, 1};
    const Placement pruned = prune_knots(points, dense, tolerance);
    EXPECT_LT(pruned.knots.u.size() + pruned.knots.v.size(), 16u);
    const LeastSquaresResult fit = fit_least_squares(points, KnotVector::clamped(3, pruned.knots.u),
                                                     KnotVector::clamped(3, pruned.knots.v));
    EXPECT_LE(measured_error(fit.errors, tolerance), tolerance.value * (1 + 1e-5));
    EXPECT_EQ(pruned.status, PlacementStatus::converged);
    // What is left is a part of what was given.
    EXPECT_TRUE(std::includes(dense.u.begin(), dense.u.end(), pruned.knots.u.begin(), pruned.knots.u.end()));
    EXPECT_TRUE(std::includes(dense.v.begin(), dense.v.end(), pruned.knots.v.begin(), pruned.knots.v.end()));
  }
}

TEST(Prune, LeavesKnotsThatDoNotHoldTheTolerance) {
  const ParameterizedPoints points = synthetic_points("ridge", 2000);
  const InteriorKnots given{uniform_knots(4), uniform_knots(4)};
  const Placement pruned = prune_knots(points, given, {1e-6, ErrorMeasure::max, 1});
  EXPECT_EQ(pruned.knots, given);
  EXPECT_EQ(pruned.status, PlacementStatus::limit);
  ASSERT_EQ(pruned.notes.size(), 1u);
  EXPECT_NE(pruned.notes[0].find("do not hold the tolerance"), std::string::npos);
  expect_throw<InvalidInput>(
      [&] {
        prune_knots(points, given, {0, ErrorMeasure::max, 1});
      },
      "must be positive");
}

TEST(Prune, FindsTheKnotsThatASplineHas) {
  // Ten knots a direction, of which the spline has three.
  Random random(3);
  const std::vector<double> own{0.3, 0.5, 0.8};
  const KnotVector knots = KnotVector::clamped(3, own);
  const Surface s(knots, knots, 1, random_numbers(random, 49));
  ParameterizedPoints points;
  Uniform uniform(5);
  for (int k = 0; k < 2000; ++k) points.uv.insert(points.uv.end(), {uniform(), uniform()});
  points.values = evaluate(s, points.uv);
  const std::vector<double> many{0.1, 0.2, 0.3, 0.4, 0.45, 0.5, 0.6, 0.7, 0.8, 0.9};
  const Placement pruned = prune_knots(points, {many, many}, {1e-6, ErrorMeasure::max, 1});
  EXPECT_EQ(pruned.knots, (InteriorKnots{own, own}));
}

TEST(Sparse, FindsTheJumpsOfASpline) {
  // Rows of a cubic spline with knots at 0.25, 0.4, 0.7 and large jumps.
  const std::vector<double> own{0.25, 0.4, 0.7};
  ParameterizedPoints points;
  points.height_field = true;
  for (int i = 0; i <= 120; ++i)
    for (int j = 0; j <= 10; ++j) {
      const double u = i / 120.0, v = j / 10.0;
      double z = u * (1 + v);
      for (std::size_t k = 0; k < own.size(); ++k)
        z += (k % 2 ? -30.0 : 20.0) * (1 + 0.5 * v) * std::pow(std::max(0.0, u - own[k]), 3);
      points.uv.insert(points.uv.end(), {u, v});
      points.values.push_back(z);
    }
  PlacementOptions options;
  options.interior_u = 3;
  options.interior_v = 0;
  options.degree_v = 2;
  const Placement placement = place_knots("sparse", points, options);
  // The dense knots stand 1/61 apart.
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(placement.knots.u[k], own[k], 1.5 / 61) << k;
}

TEST(ConjugateGradient, LowersTheErrorFromUniform) {
  for (const char* name : {"franke", "ridge"}) {
    const ParameterizedPoints points = synthetic_points(name, 3000);
    EXPECT_LT(rms(points, place_knots("conjugate-gradient", points).knots),
              0.95 * rms(points, {uniform_knots(8), uniform_knots(8)}))
        << name;
  }
}

TEST(ConjugateGradient, IsNeverWorseThanItsStart) {
  for (const std::string& name : synthetic_names()) {
    const ParameterizedPoints points = synthetic_points(name, 1000);
    for (const auto& [u, v] : {std::pair{1, 0}, std::pair{4, 3}, std::pair{9, 9}}) {
      PlacementOptions options;
      options.interior_u = u;
      options.interior_v = v;
      EXPECT_LE(rms(points, place_knots("conjugate-gradient", points, options).knots),
                rms(points, {uniform_knots(u), uniform_knots(v)}) * (1 + 1e-9))
          << name << " " << u << " x " << v;
    }
  }
}

TEST(Evolutionary, KeepsToItsBudgetAndRepeats) {
  const ParameterizedPoints points = synthetic_points("ridge", 1000);
  for (const PlacementMethod& method : placement_methods()) {
    if (!method.name.starts_with("evolutionary")) continue;
    PlacementOptions options;
    options.interior_u = options.interior_v = 4;
    options.evaluations = 400;
    const Placement one = place_knots(method.name, points, options),
                    two = place_knots(method.name, points, options);
    EXPECT_EQ(one.knots, two.knots) << method.name;
    EXPECT_LE(one.fits, 400) << method.name;
    EXPECT_GE(one.fits, 300) << method.name;
    EXPECT_EQ(one.status, PlacementStatus::limit);
    EXPECT_LE(rms(points, one.knots), rms(points, {uniform_knots(4), uniform_knots(4)})) << method.name;
    options.evaluations = 4000;
    EXPECT_LE(rms(points, place_knots(method.name, points, options).knots),
              rms(points, one.knots) * (1 + 1e-9))
        << method.name;
  }
}

TEST(Evolutionary, WithoutNloptIsSaidSo) {
  const ParameterizedPoints points = synthetic_points("franke", 200);
  const auto methods = placement_methods();
  const bool there = std::any_of(methods.begin(), methods.end(),
                                 [](const PlacementMethod& m) { return m.name == "evolutionary"; });
  if (there) GTEST_SKIP() << "built with NLopt";
  expect_throw<InvalidInput>([&] { place_knots("evolutionary", points); }, "built without NLopt");
}

}  // namespace
}  // namespace knotfit::test
