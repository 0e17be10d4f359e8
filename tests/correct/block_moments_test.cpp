#include "correct/block_moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "solve/axis.h"
#include "support/random_splines.h"
namespace knotfit::correction {
namespace {

using namespace knotfit::test;

double legendre(int a, double t) {
  return std::legendre(static_cast<unsigned>(a), t);
}

/// B_i(t) of the one span that an axis without knots has.
double function(const Axis& axis, int i, double t) {
  double sum = 0;
  for (int a = 0; a < axis.width(); ++a) sum += axis.basis(0)[a * axis.width() + i] * legendre(a, t);
  return sum;
}

TEST(BlockMoments, AreThePlainSums) {
  Random random;
  for (const auto& [p, q] : {std::pair{3, 3}, std::pair{2, 5}, std::pair{1, 1}}) {
    const Axis outer(p), inner(q);
    std::vector<BlockPoint> points(30);
    for (BlockPoint& point : points) {
      point.t = random.uniform(-1, 1), point.s = random.uniform(-1, 1), point.weight = random.uniform(0, 2);
      for (double& x : point.matrix) x = random.uniform(-1, 1);
      for (double& x : point.rhs) x = random.uniform(-1, 1);
    }
    const int qo = 2 * p + 1, qi = 2 * q + 1, stride = padded_moments(qi), wo = p + 1, wi = q + 1;
    std::vector<double> moments(6 * qo * stride, 1.0), right(3 * wo * wi, 2.0);  // added to what is there
    const double trace =
        add_block_moments(points, p, q, outer.basis(0), inner.basis(0), 6, moments.data(), right.data());
    double expected_trace = 0;
    for (const BlockPoint& point : points)
      for (int i = 0; i < wo; ++i)
        for (int j = 0; j < wi; ++j)
          expected_trace +=
              point.weight * std::pow(function(outer, i, point.t) * function(inner, j, point.s), 2);
    EXPECT_NEAR(trace, expected_trace, 1e-11);
    for (int c = 0; c < 6; ++c)
      for (int a = 0; a < qo; ++a)
        for (int b = 0; b < qi; ++b) {
          double sum = 1;
          for (const BlockPoint& point : points)
            sum += point.matrix[c] * legendre(a, point.t) * legendre(b, point.s);
          EXPECT_NEAR(moments[(c * qo + a) * stride + b], sum, 1e-12);
        }
    for (int d = 0; d < 3; ++d)
      for (int i = 0; i < wo; ++i)
        for (int j = 0; j < wi; ++j) {
          double sum = 2;
          for (const BlockPoint& point : points)
            sum += point.rhs[d] * function(outer, i, point.t) * function(inner, j, point.s);
          EXPECT_NEAR(right[(d * wo + i) * wi + j], sum, 1e-12);
        }
  }
}

TEST(BlockMoments, ArePaddedToMultiplesOfEight) {
  EXPECT_EQ(padded_moments(7), 8);
  EXPECT_EQ(padded_moments(8), 8);
  EXPECT_EQ(padded_moments(9), 16);
}

}  // namespace
}  // namespace knotfit::correction
