#include "knotfit/closest_point.h"

#include <gtest/gtest.h>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
#include "support/sampling.h"
#include "support/two_threads.h"
namespace knotfit {
namespace {

using namespace test;

/// Creases, but no jumps.
Surface continuous_surface(Random& random, Ends ends, int max_breaks) {
  const auto knots = [&] {
    const int degree = random.integer(1, kMaxDegree);
    return random_knots(random, degree, ends, max_breaks, degree);
  };
  KnotVector u = knots(), v = knots();
  std::vector<double> net = random_numbers(random, u.size() * v.size() * 3, random.log_uniform(1e-6, 1e6));
  return Surface(std::move(u), std::move(v), 3, std::move(net));
}

std::vector<double> points_around(Random& random, const Surface& s, int count, double reach) {
  std::vector<double> points;
  for (int k = 0; k < count; ++k) {
    double p[3];
    evaluate(s, random_parameter(random, s.knots_u()), random_parameter(random, s.knots_v()), p);
    for (const double x : p) points.push_back(x + random.uniform(-reach, reach) * s.scale());
  }
  return points;
}

/// The least distance over a dense grid: no surface is nearer than its closest point.
double brute_force(const std::vector<double>& grid, const double* p) {
  double least = INFINITY;
  for (std::size_t i = 0; i < grid.size(); i += 3)
    least = std::min(least, std::hypot(grid[i] - p[0], grid[i + 1] - p[1], grid[i + 2] - p[2]));
  return least;
}

TEST(ClosestPoint, IsNoFartherThanAnyOfADenseSampling) {
  Random random;
  for (int repeat = 0; repeat < 25; ++repeat) {
    const Surface s = continuous_surface(random, Ends::any, 3);  // wild: many local minima
    const std::vector<double> grid =
        evaluate_grid(s, dense_parameters(s.knots_u(), 24), dense_parameters(s.knots_v(), 24));
    for (const double reach : {1e-3, 0.3, 3.0}) {
      const std::vector<double> points = points_around(random, s, 12, reach);
      const ClosestPoints found = closest_points(s, points);
      for (std::size_t k = 0; k < found.distances.size(); ++k) {
        EXPECT_LE(found.distances[k], brute_force(grid, &points[3 * k]) + evaluation_error(s))
            << "repeat " << repeat << " reach " << reach << " point " << k;
        double p[3];
        evaluate(s, found.uv[2 * k], found.uv[2 * k + 1], p);
        for (int d = 0; d < 3; ++d) EXPECT_EQ(p[d], found.points[3 * k + d]);
        EXPECT_EQ(found.distances[k], std::sqrt((p[0] - points[3 * k]) * (p[0] - points[3 * k]) +
                                                (p[1] - points[3 * k + 1]) * (p[1] - points[3 * k + 1]) +
                                                (p[2] - points[3 * k + 2]) * (p[2] - points[3 * k + 2])));
      }
    }
  }
}

TEST(ClosestPoint, AStartChangesNothing) {
  Random random;
  for (int repeat = 0; repeat < 10; ++repeat) {
    const Surface s = continuous_surface(random, Ends::clamped, 3);
    const std::vector<double> points = points_around(random, s, 30, 0.5);
    std::vector<double> start;  // nowhere near
    for (int k = 0; k < 30; ++k)
      start.insert(start.end(),
                   {random_parameter(random, s.knots_u()), random_parameter(random, s.knots_v())});
    const ClosestPoints a = closest_points(s, points), b = closest_points(s, points, start);
    // Newton ends where the squared distance no longer falls by 1e-15 of itself.
    for (std::size_t k = 0; k < a.distances.size(); ++k)
      EXPECT_NEAR(a.distances[k], b.distances[k], 1e-8 * a.distances[k] + evaluation_error(s))
          << repeat << " " << k;
  }
}

TEST(ClosestPoint, OfAPlaneIsTheProjection) {
  const KnotVector knots = KnotVector::uniform(2, 5);
  std::vector<double> net;
  for (const double x : knots.greville())
    for (const double y : knots.greville()) net.insert(net.end(), {4 * x, 2 * y, 1});
  const Surface plane(knots, knots, 3, net);
  const ClosestPoint inside = closest_point(plane, {3, 0.5, 4});
  EXPECT_NEAR(inside.u, 0.75, 1e-12);
  EXPECT_NEAR(inside.v, 0.25, 1e-12);
  EXPECT_NEAR(inside.distance, 3, 1e-12);
  const ClosestPoint corner = closest_point(plane, {7, -4, 1});
  EXPECT_EQ(corner.u, 1);
  EXPECT_EQ(corner.v, 0);
  EXPECT_NEAR(corner.distance, 5, 1e-12);
  EXPECT_NEAR(corner.point[0], 4, 1e-12);
}

TEST(ClosestPoint, OfALipTouchingItselfIsOnTheNearerSide) {
  // A strip bent to a U with 0.02 between its legs: the far leg is 90 % of the parameters away.
  const KnotVector u = KnotVector::uniform(3, 8), v = KnotVector::uniform(3, 1);
  std::vector<double> net;
  for (const double x : u.greville())
    for (const double y : v.greville()) net.insert(net.end(), {1 - std::abs(2 * x - 1), y, 0.02 * x});
  const Surface strip(u, v, 3, net);
  for (const double height : {-0.01, 0.001, 0.019, 0.03})
    for (const double start : {0.05, 0.95}) {
      const std::vector<double> p{0.1, 0.5, height}, from{start, 0.5};
      const ClosestPoints c = closest_points(strip, p, from);
      EXPECT_EQ(c.uv[0] < 0.5, height < 0.01) << height << " from " << start;
    }
}

TEST(ClosestPoint, OfASphereFromItsCentreIsAsFarAsItsRadius) {
  // Cubic interpolation of an octant is good to 1e-4; every point is equally near to within that.
  const KnotVector knots = KnotVector::uniform(3, 6);
  std::vector<double> net;
  for (const double a : knots.greville())
    for (const double b : knots.greville()) {
      const double t = 1.2 * a + 0.2, f = 1.4 * b;
      net.insert(net.end(), {std::sin(t) * std::cos(f), std::sin(t) * std::sin(f), std::cos(t)});
    }
  const Surface ball(knots, knots, 3, net);
  const std::vector<double> grid =
      evaluate_grid(ball, dense_parameters(ball.knots_u(), 20), dense_parameters(ball.knots_v(), 20));
  const double centre[3] = {0, 0, 0};
  EXPECT_NEAR(closest_point(ball, {0, 0, 0}).distance, brute_force(grid, centre), 2e-4);
}

TEST(ClosestPoint, SameBitsForOneAndTwoThreads) {
  Random random;
  const Surface s = random_surface(random, 3, Ends::clamped, 5);
  const std::vector<double> points = points_around(random, s, 2000, 0.2);
  const auto [one, two] = on_one_and_two_threads([&] { return closest_points(s, points); });
  EXPECT_EQ(one.uv, two.uv);
  EXPECT_EQ(one.distances, two.distances);
}

TEST(ClosestPoint, StopsWhenAsked) {
  Random random;
  const Surface s = random_surface(random, 3, Ends::clamped, 2);
  const std::vector<double> points = points_around(random, s, 20000, 0.1);
  std::stop_source stop;
  Control control;
  control.stop = stop.get_token();
  control.progress = [&](const Progress& p) {
    EXPECT_EQ(p.stage, "closest points");
    stop.request_stop();
  };
  const ClosestPoints found = closest_points(s, points, {}, control);
  EXPECT_TRUE(found.stopped);
  EXPECT_TRUE(std::isfinite(found.distances.front()));
  EXPECT_TRUE(std::isinf(found.distances.back()));
}

TEST(ClosestPoint, RefusesWhatHasNone) {
  Random random;
  const Surface s = random_surface(random, 3), flat = random_surface(random, 1);
  expect_throw<InvalidInput>([&] { closest_point(Surface(), {0, 0, 0}); }, "is empty");
  expect_throw<InvalidInput>(
      [&] {
        closest_point(flat, {0, 0, 0});
      },
      "has 1 coordinate (height_field_in_space");
  expect_throw<InvalidInput>([&] { closest_point(s, {0, NAN, 0}); }, "point 0 is not finite");
  expect_throw<InvalidInput>(
      [&] {
        closest_points(s, std::vector<double>{1, 2});
      },
      "2 numbers are no points");
  expect_throw<InvalidInput>(
      [&] {
        closest_points(s, std::vector<double>{1, 2, 3}, std::vector<double>{1});
      },
      "1 points have 1 parameters");
  expect_throw<InvalidInput>(
      [&] {
        closest_points(s, std::vector<double>{1, 2, 3}, std::vector<double>{1, NAN});
      },
      "the start of point 0");
  EXPECT_TRUE(closest_points(s, {}).distances.empty());
}

}  // namespace
}  // namespace knotfit
