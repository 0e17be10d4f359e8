#include "knotfit/evaluate.h"

#include <gtest/gtest.h>

#include <limits>

#include "knotfit/exceptions.h"
#include "spline/reference.h"
#include "support/expect_gradient.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
#include "support/sampling.h"
namespace knotfit::test {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();

std::vector<double> value(const Surface& s, double u, double v) {
  std::vector<double> out(static_cast<std::size_t>(s.dimension()));
  evaluate(s, u, v, out);
  return out;
}

TEST(Evaluate, KeepsTheErrorItPromises) {
  Random random;
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    const Surface s = random_surface(random, random.integer(1, 3));
    for (int l = 0; l < 10; ++l) {
      const double u = random_parameter(random, s.knots_u()), v = random_parameter(random, s.knots_v());
      const std::vector<double> found = value(s, u, v);
      const std::vector<Long> expected = reference_value(s, u, v);
      for (std::size_t d = 0; d < found.size(); ++d) {
        const double error = static_cast<double>(std::abs(found[d] - expected[d]));
        EXPECT_LE(error, evaluation_error(s));
        worst = std::max(worst, error / evaluation_error(s));
      }
    }
  }
  RecordProperty("worst_part_of_the_bound", std::to_string(worst));
}

TEST(Evaluate, InterpolatesTheCornersOfAClampedNet) {
  for (const Surface& s : random_surfaces(seed(), 50, Ends::clamped)) {
    const auto corner = [&](Index i, Index j) {
      const auto point = s.control_point(i, j);
      return std::vector<double>(point.begin(), point.end());
    };
    EXPECT_EQ(value(s, s.knots_u().first(), s.knots_v().first()), corner(0, 0));
    EXPECT_EQ(value(s, s.knots_u().last(), s.knots_v().last()), corner(s.size_u() - 1, s.size_v() - 1));
  }
}

TEST(Evaluate, ClampsParametersToTheDomain) {
  for (const Surface& s : random_surfaces(seed(), 50)) {
    const KnotVector &ku = s.knots_u(), &kv = s.knots_v();
    EXPECT_EQ(value(s, ku.first() - 1, kv.last() + 2), value(s, ku.first(), kv.last()));
    EXPECT_EQ(value(s, kInf, -kInf), value(s, ku.last(), kv.first()));
    EXPECT_EQ(evaluate_derivatives(s, ku.last() + 1, kv.last() + 1, 3),
              evaluate_derivatives(s, ku.last(), kv.last(), 3));
  }
}

TEST(Evaluate, GivesNanForANanParameter) {
  const Surface s = random_surfaces(seed(), 1)[0];
  const double u = s.knots_u().first(), v = s.knots_v().first();
  for (double x : value(s, kNan, v)) EXPECT_TRUE(std::isnan(x));
  for (double x : value(s, u, kNan)) EXPECT_TRUE(std::isnan(x));
  const std::vector<double> all = evaluate_derivatives(s, u, kNan, 12);  // above the degree, too
  for (int a = 0; a <= 12; ++a)
    for (int b = 0; b <= 12; ++b)
      for (int d = 0; d < s.dimension(); ++d) {
        const double x = all[static_cast<std::size_t>((a * 13 + b) * s.dimension() + d)];
        EXPECT_TRUE(a + b <= 12 ? std::isnan(x) : x == 0);
      }
}

// Every term of a derivative is right to 8 (degree + 1) eps a direction, as in basis_test.cpp.
TEST(EvaluateDerivatives, AreWhatTheRecursionGives) {
  Random random;
  for (int k = 0; k < 30; ++k) {
    const Surface s = random_surface(random, 2);
    const double u = random_parameter(random, s.knots_u()), v = random_parameter(random, s.knots_v());
    const int order = 5;
    const std::vector<double> all = evaluate_derivatives(s, u, v, order);
    for (int a = 0; a <= order; ++a)
      for (int b = 0; b <= order; ++b) {
        const std::vector<Long> expected = reference_value(s, u, v, a, b);
        const std::vector<Long> size = reference_value(s, u, v, a, b, true);
        for (std::size_t d = 0; d < 2; ++d) {
          const double found = all[static_cast<std::size_t>((a * (order + 1) + b) * 2) + d];
          if (a + b > order) {
            EXPECT_EQ(found, 0);
          } else {
            const double bound = 8 * (s.degree_u() + s.degree_v() + 2) * kEps * static_cast<double>(size[d]);
            EXPECT_NEAR(found, static_cast<double>(expected[d]), bound);
          }
        }
      }
  }
}

TEST(EvaluateDerivatives, AreZeroAboveTheDegree) {
  Random random;
  const Surface s(KnotVector::uniform(2, 2), KnotVector::uniform(1, 3), 1, random_numbers(random, 25));
  const std::vector<double> all = evaluate_derivatives(s, 0.4, 0.6, 6);
  for (int a = 0; a <= 6; ++a)
    for (int b = 0; a + b <= 6; ++b)
      EXPECT_EQ(all[static_cast<std::size_t>(a * 7 + b)] == 0, a > 2 || b > 1) << a << " " << b;
}

TEST(EvaluateDerivatives, AgreeWithDifferences) {
  Random random;
  for (int k = 0; k < 50; ++k) {
    const int p = random.integer(3, kMaxDegree), q = random.integer(3, kMaxDegree);
    const KnotVector u = KnotVector::uniform(p, 0), v = KnotVector::uniform(q, 0);
    const Surface s(u, v, 1, random_numbers(random, u.size() * v.size()));
    const std::vector<double> at = {random.uniform(0.1, 0.9), random.uniform(0.1, 0.9)};
    const std::vector<double> all = evaluate_derivatives(s, at[0], at[1], 1);
    expect_gradient([&](const std::vector<double>& x) { return value(s, x[0], x[1])[0]; }, at,
                    std::vector<double>{all[2], all[1]}, 1e-3, 100);
  }
}

// Marsden: sum_i B_i(x) prod_k (y - t_{i+k}) = (y - x)^degree [deBoor01 (IX.10)], in both
// directions at once.
TEST(Evaluate, ReproducesEveryPolynomialOfItsDegrees) {
  Random random;
  for (int k = 0; k < 200; ++k) {
    const KnotVector u = random_knots(random, random.integer(1, kMaxDegree));
    const KnotVector v = random_knots(random, random.integer(1, kMaxDegree));
    const auto points = [&](const KnotVector& t, double y) {
      std::vector<double> c(static_cast<std::size_t>(t.size()), 1.0);
      for (Index i = 0; i < t.size(); ++i)
        for (int l = 1; l <= t.degree(); ++l) c[i] *= y - t[i + l];
      return c;
    };
    const double y = random_parameter(random, u), z = random_parameter(random, v);
    std::vector<double> net;
    for (double a : points(u, y))
      for (double b : points(v, z)) net.push_back(a * b);
    const Surface s(u, v, 1, net);
    for (int l = 0; l < 10; ++l) {
      const double x = random_parameter(random, u), w = random_parameter(random, v);
      Long expected = 1;
      for (int i = 0; i < u.degree(); ++i) expected *= static_cast<Long>(y) - x;
      for (int i = 0; i < v.degree(); ++i) expected *= static_cast<Long>(z) - w;
      // 2 roundings a factor of a control point.
      const double rounding = (u.degree() + v.degree()) * 2 * kEps * s.scale();
      EXPECT_NEAR(value(s, x, w)[0], static_cast<double>(expected), rounding + evaluation_error(s));
    }
  }
}

TEST(Evaluate, NamesWhatIsWrong) {
  const Surface s(KnotVector::uniform(2, 0), KnotVector::uniform(2, 0), 3, std::vector<double>(27, 1.0));
  std::vector<double> two(2);
  expect_throw<InvalidInput>([&] { evaluate(s, 0, 0, two); }, "dimension 3 does not fit into 2 numbers");
  expect_throw<InvalidInput>([&] { evaluate(Surface(), 0, 0, two); }, "surface to evaluate is empty");
  expect_throw<InvalidInput>([&] { evaluate_derivatives(s, 0, 0, -2); }, "orders must be >= 0");
  expect_throw<InvalidInput>([&] { evaluate_derivatives(Surface(), 0, 0, 1); },
                             "surface to evaluate is empty");
}

}  // namespace
}  // namespace knotfit::test
