#include "place/free_net.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "knotfit/evaluate.h"
#include "place/knot_spacings.h"
#include "place/shares.h"
#include "support/expect_gradient.h"
#include "support/random_splines.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

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

}  // namespace
}  // namespace knotfit::test
