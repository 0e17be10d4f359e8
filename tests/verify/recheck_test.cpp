#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/threads.h"
#include "knotfit/verify.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
#include "support/synthetic.h"
#include "verify/de_boor.h"
namespace knotfit {
namespace {

using test::expect_throw;

// B_{i,p}(x) by its recursion: slow, and nothing but the definition.
double basis(const KnotVector& t, Index i, int p, double x) {
  if (p == 0) {
    const bool last = x == t.last() && t[i] < t[i + 1] && t[i + 1] == t.last();
    return (t[i] <= x && x < t[i + 1]) || last ? 1 : 0;
  }
  double sum = 0;
  if (t[i + p] > t[i]) sum += (x - t[i]) / (t[i + p] - t[i]) * basis(t, i, p - 1, x);
  if (t[i + p + 1] > t[i + 1])
    sum += (t[i + p + 1] - x) / (t[i + p + 1] - t[i + 1]) * basis(t, i + 1, p - 1, x);
  return sum;
}

std::vector<double> by_definition(const Surface& s, double u, double v) {
  std::vector<double> sum(static_cast<std::size_t>(s.dimension()), 0);
  for (Index i = 0; i < s.size_u(); ++i)
    for (Index j = 0; j < s.size_v(); ++j) {
      const double weight = basis(s.knots_u(), i, s.degree_u(), u) * basis(s.knots_v(), j, s.degree_v(), v);
      for (int d = 0; d < s.dimension(); ++d) sum[d] += weight * s.control_point(i, j)[d];
    }
  return sum;
}

Surface random_surface(test::Random& random, int degree_u, int degree_v, int dimension) {
  auto knots = [&](int degree) {
    std::vector<double> interior;
    for (int k = random.integer(0, 5); k > 0; --k) {
      const double t = random.uniform(0.05, 0.95);
      for (int copies = random.integer(1, degree + 1); copies > 0; --copies) interior.push_back(t);
    }
    std::sort(interior.begin(), interior.end());
    return KnotVector::clamped(degree, interior);
  };
  const KnotVector u = knots(degree_u), v = knots(degree_v);
  std::vector<double> net(static_cast<std::size_t>(u.size() * v.size() * dimension));
  for (double& x : net) x = random.uniform(-1, 1);
  return {u, v, dimension, net};
}

TEST(DeBoor, AgreesWithTheDefinition) {
  test::Random random;
  for (int trial = 0; trial < 120; ++trial) {
    const Surface s = random_surface(random, random.integer(1, trial < 100 ? 4 : 9), random.integer(1, 4),
                                     random.integer(1, 5));
    std::vector<double> out(static_cast<std::size_t>(s.dimension()));
    std::vector<double> us = s.knots_u().breaks(), vs = s.knots_v().breaks();
    for (int k = 0; k < 4; ++k) us.push_back(random.unit()), vs.push_back(random.unit());
    for (double u : us)
      for (double v : vs) {
        verify::de_boor(s, u, v, out);
        const std::vector<double> expected = by_definition(s, u, v);
        // Rounding of a triangle in each direction, and of the sum it is held against.
        const double bound = (s.degree_u() + s.degree_v() + 2) * 8 * test::kEps * s.scale();
        for (int d = 0; d < s.dimension(); ++d) EXPECT_NEAR(out[d], expected[d], bound) << u << " " << v;
      }
  }
}

TEST(DeBoor, AgreesWithTheLibrarysEvaluation) {
  test::Random random;
  for (int trial = 0; trial < 50; ++trial) {
    const Surface s = random_surface(random, random.integer(1, 9), random.integer(1, 9), 3);
    std::vector<double> a(3), b(3);
    for (int k = 0; k < 50; ++k) {
      const double u = random.unit(), v = random.unit();
      verify::de_boor(s, u, v, a);
      evaluate(s, u, v, b);
      for (int d = 0; d < 3; ++d)
        EXPECT_NEAR(a[d], b[d], (s.degree_u() + s.degree_v() + 2) * 8 * test::kEps * s.scale());
    }
  }
}

TEST(Distance, HoldsAtAnyScale) {
  for (double scale : {1e-300, 1e-170, 1.0, 1e170, 1e300}) {
    const double a[] = {3 * scale, 0, 0}, b[] = {0, -4 * scale, 0};
    EXPECT_NEAR(verify::distance(a, b) / scale, 5, 1e-14);
  }
  const double zero[] = {1, 2};
  EXPECT_EQ(verify::distance(zero, zero), 0);
  const double big[] = {1e308, 0}, other[] = {-1e308, 0};
  EXPECT_EQ(verify::distance(big, other), INFINITY);
}

TEST(Recheck, IsTheDistanceOfEveryPointInInputOrder) {
  const ParameterizedPoints points = test::synthetic_points("torus", 9000);
  test::Random random;
  const Surface s = random_surface(random, 3, 2, 3);
  const std::vector<double> errors = recheck_errors(s, points);
  ASSERT_EQ(errors.size(), 9000u);
  std::vector<double> at(3);
  for (Index k = 0; k < 9000; k += 37) {
    evaluate(s, points.u(k), points.v(k), at);
    EXPECT_NEAR(errors[k], verify::distance(at, {points.value(k), 3}), 1e-13);
  }
}

TEST(Recheck, IsZeroOnTheSurfaceItself) {
  const std::vector<double> z = {1, 1, 2, 2};
  const Surface plane(KnotVector::uniform(1, 0), KnotVector::uniform(1, 0), 1, z);
  ParameterizedPoints points;
  points.uv = {0, 0, 0.25, 0.5, 1, 1, 0.5, 1};
  points.values = {1, 1.25, 2, 1.5};
  for (double e : recheck_errors(plane, points)) EXPECT_EQ(e, 0);
}

TEST(Recheck, SameBitsForOneAndTwoThreads) {
  const ParameterizedPoints points = test::synthetic_points("torus", 20000);
  test::Random random;
  const Surface s = random_surface(random, 3, 3, 3);
  set_thread_count(1);
  const std::vector<double> one = recheck_errors(s, points);
  set_thread_count(2);
  EXPECT_EQ(recheck_errors(s, points), one);
  set_thread_count(0);
}

TEST(Recheck, RefusesWhatDoesNotFitTogether) {
  const Surface plane(KnotVector::uniform(1, 0), KnotVector::uniform(1, 0), 1, {0, 0, 0, 0});
  ParameterizedPoints points = test::synthetic_points("torus", 10);
  expect_throw<InvalidInput>([&] { recheck_errors(plane, points); },
                             "dimension 1 cannot be checked against points of dimension 3");
  expect_throw<InvalidInput>([&] { recheck_errors(Surface(), points); }, "control net is empty");
  points.uv[4] = 1.5;
  expect_throw<InvalidInput>([&] { recheck_errors(plane, points); }, "outside [0,1]");
}

}  // namespace
}  // namespace knotfit
