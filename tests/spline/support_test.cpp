// The helpers that other tests lean on.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_gradient.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

double wave(const std::vector<double>& x) {
  return std::sin(3 * x[0]) * std::exp(x[1]);
}
std::vector<double> slope(double x, double y) {
  return {3 * std::cos(3 * x) * std::exp(y), std::sin(3 * x) * std::exp(y)};
}

TEST(ExpectGradient, AcceptsARightGradient) {
  Random random;
  for (int k = 0; k < 100; ++k) {
    const std::vector<double> at = random_numbers(random, 2, 2);
    expect_gradient(wave, at, slope(at[0], at[1]));
  }
}

TEST(ExpectGradient, RefusesOneThatIsWrongBySixDigits) {
  static std::vector<double> at, wrong;
  at = {0.2, 0.3};
  wrong = slope(0.2, 0.3);
  wrong[1] *= 1 + 1e-6;
  EXPECT_NONFATAL_FAILURE(expect_gradient(wave, at, wrong), "derivative by x_1");
}

TEST(RandomKnots, CoverMultiplicitiesEndsAndDegrees) {
  Random random;
  int open = 0, jumps = 0, doubled = 0;
  for (int k = 0; k < 500; ++k) {
    const KnotVector t = random_knots(random, random.integer(1, kMaxDegree));
    open += !t.is_clamped();
    for (double x : t.interior()) {
      jumps += t.multiplicity(x) == t.degree() + 1;
      doubled += t.multiplicity(x) == 2;
    }
  }
  EXPECT_GT(open, 100);
  EXPECT_GT(jumps, 50);
  EXPECT_GT(doubled, 50);
}

TEST(RandomSplines, AreTheSameForTheSameSeed) {
  const std::vector<Surface> a = random_surfaces(7, 5), b = random_surfaces(7, 5), c = random_surfaces(8, 5);
  EXPECT_EQ(a, b);
  EXPECT_NE(a, c);
}

}  // namespace
}  // namespace knotfit::test
