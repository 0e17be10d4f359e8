// Knots that minimise the fitting error itself [METHOD 3.5].
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fit/moving_fit.h"
#include "knotfit/evaluate.h"
#include "knotfit/place.h"
#include "place/relocate.h"
#include "place/shares.h"
#include "support/synthetic.h"
#include "support/two_threads.h"
namespace knotfit::test {
namespace {

LeastSquaresOptions for_knots() {
  LeastSquaresOptions options;
  options.refinement_steps = 0;
  options.use_grid = false;
  options.estimate_condition = false;
  return options;
}

double rms_of(const ParameterizedPoints& points, const InteriorKnots& knots) {
  MovingFit problem(points, 3, 3, for_knots());
  problem.solve(knots);
  return problem.rms();
}

TEST(KnotSpacings, GiveTheirKnotsBack) {
  const std::vector<double> knots{0.1, 0.3, 0.3, 0.7, 0.7, 0.7, 0.9};
  const KnotSpacings spacings(knots);
  EXPECT_EQ(spacings.length.size(), 5u);
  EXPECT_EQ(spacings.multiplicity, (std::vector<int>{1, 2, 3, 1}));
  EXPECT_EQ(spacings.knot_count(), knots.size());
  const std::vector<double> back = spacings.knots();
  ASSERT_EQ(back.size(), knots.size());
  for (std::size_t i = 0; i < knots.size(); ++i) EXPECT_NEAR(back[i], knots[i], 4e-16);
  EXPECT_EQ(back[1], back[2]);
  EXPECT_TRUE(KnotSpacings(std::vector<double>{}).knots().empty());
}

TEST(KnotSpacings, ChainIsTheDerivativeOfMoved) {
  const KnotSpacings s(std::vector<double>{0.15, 0.4, 0.4, 0.8});
  const std::size_t n = s.length.size();
  std::vector<double> chain(s.knot_count() * n);
  s.chain(chain, 0, 0, n);
  const double h = 1e-6;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> step(n, 0.0);
    step[i] = h;
    const std::vector<double> after = s.moved(step.data(), 0).knots();
    step[i] = -h;
    const std::vector<double> before = s.moved(step.data(), 0).knots();
    for (std::size_t j = 0; j < after.size(); ++j)
      EXPECT_NEAR(chain[j * n + i], (after[j] - before[j]) / (2 * h), 1e-9);
  }
}

TEST(KnotSpacings, NoSpanFallsBelowTheLeast) {
  const KnotSpacings s(std::vector<double>{0.2, 0.4, 0.6, 0.8});
  const double step[] = {-9, 1, -5, 0.5, 0};
  const KnotSpacings m = s.moved(step, 0.05);
  double sum = 0;
  for (double x : m.length) {
    EXPECT_GE(x, 0.05 / 5 * (1 - 1e-12));
    sum += x;
  }
  EXPECT_NEAR(sum, 1, 1e-14);
}

TEST(Levenberg, NeverEndsAboveItsStartAndAtASmallGradient) {
  const ParameterizedPoints points = synthetic_points("franke", 5000);
  MovingFit problem(points, 3, 3, for_knots());
  InteriorKnots knots{{0.1, 0.3, 0.5, 0.7, 0.9}, {0.2, 0.4, 0.6, 0.8}};
  // What a Newton step could still gain: g^T H^-1 g, the gradient in the measure of its own steps.
  const auto gradient = [&] {
    SpacingStep step(problem, knots, false);
    EXPECT_TRUE(step.solve(1e-9, 1e9));
    return step.predicted_fall();
  };
  problem.solve(knots);
  const double before = problem.phi(), gradient_before = gradient();
  LevenbergOptions options;
  options.fall = 1e-8;
  options.steps = 200;
  const double phi = minimize_over_knots(problem, knots, options);
  EXPECT_LT(phi, 0.6 * before);  // measured: 0.164
  EXPECT_EQ(problem.knots(), knots);
  EXPECT_EQ(problem.phi(), phi);
  EXPECT_LT(gradient(), 1e-8 * phi);              // measured: 4e-10, where two falls below 1e-8 end it
  EXPECT_LT(gradient(), 1e-8 * gradient_before);  // measured: 2e-10
}

TEST(Optimal, IsNeverWorseThanItsStarts) {
  for (const std::string& name : synthetic_names()) {
    const ParameterizedPoints points = synthetic_points(name, 2000);
    PlacementOptions options;
    options.interior_u = 7;
    options.interior_v = 6;
    options.evaluations = 300;
    const double optimal = rms_of(points, place_knots("optimal", points, options).knots);
    for (const PlacementMethod& method : placement_methods())
      EXPECT_LE(optimal, rms_of(points, place_knots(method.name, points, options).knots) * (1 + 1e-9))
          << name << " " << method.name;
  }
}

TEST(Relocation, OneKnotAtMorePeaksOfTheGainLeadsFurther) {
  int further = 0;
  for (const std::string& name : synthetic_names())
    for (const int count : {6, 10}) {
      const ParameterizedPoints points = synthetic_points(name, 1500);
      MovingFit problem(points, 3, 3, for_knots());
      InteriorKnots knots{uniform_knots(count), uniform_knots(count)};
      double phi = minimize_over_knots(problem, knots);
      phi = relocate_knots(problem, knots, phi, {});
      const double more = relocate_knots(problem, knots, phi, {}, {.candidates = 4, .peaks = 3});
      EXPECT_LE(more, phi) << name;
      EXPECT_EQ(problem.knots(), knots);
      EXPECT_NEAR(problem.phi(), more, 1e-12 * more);
      EXPECT_EQ(knots.u.size() + knots.v.size(), 2u * count);
      further += more < (1 - 1e-3) * phi;
    }
  EXPECT_GT(further, 0);
}

/// Data of a spline with these knots: a random net, sampled.
ParameterizedPoints of_spline(const std::vector<double>& u, const std::vector<double>& v,
                              std::uint64_t seed) {
  Uniform uniform(seed);
  const KnotVector ku = KnotVector::clamped(3, u), kv = KnotVector::clamped(3, v);
  std::vector<double> net(ku.size() * kv.size());
  for (double& x : net) x = 2 * uniform() - 1;
  const Surface s(ku, kv, 1, net);
  ParameterizedPoints points;
  for (int k = 0; k < 6000; ++k) points.uv.insert(points.uv.end(), {uniform(), uniform()});
  points.values = evaluate(s, points.uv);
  return points;
}

/// Uneven knots, lengths within 0.3 to 1.3 of one unit; a pair of them equal where `doubled`.
std::vector<double> uneven_knots(Uniform& uniform, int count, bool doubled) {
  std::vector<double> knots(count), length(count + 1);
  double at = 0, sum = 0;
  for (double& h : length) sum += h = 0.3 + uniform();
  for (int i = 0; i < count; ++i) knots[i] = at += length[i] / sum;
  if (doubled) {
    const int i = static_cast<int>(uniform() * (count - 1));
    knots[i + 1] = knots[i];
  }
  return knots;
}

/// How far the knots found are from those the data was made with.
double farthest_from_known(int count, bool doubled, std::uint64_t seed) {
  Uniform uniform(100 * count + seed);
  const std::vector<double> u = uneven_knots(uniform, count, doubled),
                            v = uneven_knots(uniform, count, doubled);
  const ParameterizedPoints points = of_spline(u, v, seed);
  PlacementOptions options;
  options.interior_u = options.interior_v = count;
  options.smoothing = 1e-14;
  const InteriorKnots knots = place_knots("optimal", points, options).knots;
  double worst = 0;
  for (int i = 0; i < count; ++i)
    worst = std::max({worst, std::abs(knots.u[i] - u[i]), std::abs(knots.v[i] - v[i])});
  return worst;
}

TEST(Optimal, FindsKnownKnots) {
  for (int count : {1, 2, 4, 6})
    for (std::uint64_t seed : {1, 2}) EXPECT_LT(farthest_from_known(count, false, seed), 1e-6) << count;
}

TEST(Optimal, FindsKnownDoubleKnots) {
  for (int count : {2, 3, 5, 6})
    for (std::uint64_t seed : {1, 2}) EXPECT_LT(farthest_from_known(count, true, seed), 1e-6) << count;
}

TEST(Optimal, ACreaseBecomesAMultipleKnot) {
  ParameterizedPoints points;
  Uniform uniform(5);
  for (int k = 0; k < 5000; ++k) {
    const double u = uniform(), v = uniform();
    points.uv.insert(points.uv.end(), {u, v});
    points.values.push_back(std::abs(u - 0.43) + 0.2 * std::sin(3 * v));
  }
  PlacementOptions options;
  options.interior_u = 4;
  options.interior_v = 6;
  const InteriorKnots knots = place_knots("optimal", points, options).knots;
  const KnotVector u = KnotVector::clamped(3, knots.u);
  int most = 0;
  for (double x : knots.u) most = std::max(most, u.multiplicity(x));
  EXPECT_GE(most, 2);
  EXPECT_LT(rms_of(points, knots), 1e-5);
}

TEST(TieKnots, TiesThePairsOfBothDirections) {
  // Doubles of both directions start a little apart.
  const std::vector<double> u{0.12, 0.18, 0.26, 0.26, 0.57}, v{0.05, 0.05, 0.63, 0.83, 0.94};
  const ParameterizedPoints points = of_spline(u, v, 3);
  LeastSquaresOptions fit = for_knots();
  fit.smoothing = 1e-14;
  MovingFit problem(points, 3, 3, fit);
  InteriorKnots knots{u, v};
  for (std::vector<double>* k : {&knots.u, &knots.v})
    for (std::size_t i = 0; i + 1 < k->size(); ++i)
      if ((*k)[i] == (*k)[i + 1]) (*k)[i] -= 4e-4, (*k)[i + 1] += 4e-4;
  problem.solve(knots);
  const double before = problem.phi();
  const double phi = tie_knots(problem, knots, before, {});
  EXPECT_LT(phi, 1e-12 * before);
  EXPECT_EQ(problem.phi(), phi);
  EXPECT_EQ(knots.u[2], knots.u[3]);
  EXPECT_EQ(knots.v[0], knots.v[1]);
}

TEST(Optimal, SameKnotsForOneAndTwoThreads) {
  const ParameterizedPoints points = synthetic_points("peaks", 3000);
  PlacementOptions options;
  options.interior_u = options.interior_v = 5;
  const auto [one, two] =
      on_one_and_two_threads([&] { return place_knots("optimal", points, options).knots; });
  EXPECT_EQ(one, two);
}

}  // namespace
}  // namespace knotfit::test
