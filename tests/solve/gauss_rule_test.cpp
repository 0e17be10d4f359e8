#include "solve/gauss_rule.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solve/axis.h"
namespace knotfit {
namespace {

TEST(GaussRule, IntegratesPolynomialsToDegreeTwoNMinusOneExactly) {
  for (int n = 1; n <= 2 * kMaxDegree + 1; ++n) {
    const GaussRule rule(n);
    ASSERT_EQ(rule.node.size(), static_cast<std::size_t>(n));
    for (int k = 0; k < 2 * n; ++k) {
      double sum = 0;
      for (int g = 0; g < n; ++g) sum += rule.weight[g] * std::pow(rule.node[g], k);
      // Weights add up to 2; each term has some n roundings.
      EXPECT_NEAR(sum, k % 2 == 0 ? 2.0 / (k + 1) : 0.0, 16 * n * 0x1p-52) << n << " nodes, t^" << k;
    }
    double beyond = 0;  // t^2n is the first that it cannot do
    for (int g = 0; g < n; ++g) beyond += rule.weight[g] * std::pow(rule.node[g], 2 * n);
    EXPECT_LT(beyond, 2.0 / (2 * n + 1) * (1 - 1e-12)) << n;
  }
}

TEST(GaussRule, KnowsTheLegendrePolynomialsAtItsNodes) {
  const GaussRule rule(7);
  for (int g = 0; g < 7; ++g)
    for (int a = 0; a < 7; ++a)
      EXPECT_NEAR(rule.legendre[g * 7 + a], std::legendre(static_cast<unsigned>(a), rule.node[g]), 1e-14);
}

TEST(GaussRule, OfADegreeHasTwiceItsNodesAndOne) {
  for (int degree = 0; degree <= kMaxDegree; ++degree)
    EXPECT_EQ(gauss_rule(degree).node.size(), static_cast<std::size_t>(2 * degree + 1));
}

}  // namespace
}  // namespace knotfit
