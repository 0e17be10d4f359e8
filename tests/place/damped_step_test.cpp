#include "place/damped_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace knotfit {
namespace {

const std::vector<double> kMatrix = {4, 1, 0, 1, 3, 1, 0, 1, 2}, kGradient = {1, -2, 3};

TEST(DampedStep, WithoutDampingIsNewtons) {
  std::vector<double> step(3);
  ASSERT_TRUE(damped_step(kMatrix, kGradient, 0, 1e9, step));
  for (int i = 0; i < 3; ++i) {
    double sum = kGradient[i];
    for (int j = 0; j < 3; ++j) sum += kMatrix[3 * i + j] * step[j];
    EXPECT_NEAR(sum, 0, 1e-11);  // 1e-13 of the trace is added to the diagonal
  }
  // At the minimum of phi + 2 g.s + s.H s the model falls by g.H^-1 g.
  EXPECT_NEAR(predicted_fall(kMatrix, kGradient, step),
              -(kGradient[0] * step[0] + kGradient[1] * step[1] + kGradient[2] * step[2]), 1e-11);
}

TEST(DampedStep, GetsShorterWithDampingAndStillGoesDown) {
  double before = INFINITY;
  for (const double mu : {0.0, 0.1, 1.0, 10.0, 1e6}) {
    std::vector<double> step(3);
    ASSERT_TRUE(damped_step(kMatrix, kGradient, mu, 1e9, step));
    const double length = std::hypot(step[0], step[1], step[2]);
    EXPECT_LT(length, before);
    EXPECT_GT(predicted_fall(kMatrix, kGradient, step), 0);
    before = length;
  }
}

TEST(DampedStep, IsShortenedAsAWhole) {
  std::vector<double> whole(3), cut(3);
  ASSERT_TRUE(damped_step(kMatrix, kGradient, 0, 1e9, whole));
  ASSERT_TRUE(damped_step(kMatrix, kGradient, 0, 0.5, cut));
  const double largest = std::max({std::abs(whole[0]), std::abs(whole[1]), std::abs(whole[2])});
  ASSERT_GT(largest, 0.5);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(cut[i], whole[i] * 0.5 / largest, 1e-15);
}

TEST(Damping, FallsAfterAGoodStepAndGrowsFasterAndFaster) {
  Damping damping;
  const double start = damping.mu;
  damping.accept(1);
  EXPECT_DOUBLE_EQ(damping.mu, start * 0.1) << "the whole fall predicted";
  damping.refuse();
  EXPECT_DOUBLE_EQ(damping.mu, start * 0.2);
  damping.refuse();
  EXPECT_DOUBLE_EQ(damping.mu, start * 0.8);
  damping.accept(0);  // hardly lower than before: it grows too
  EXPECT_DOUBLE_EQ(damping.mu, start * 1.6);
  EXPECT_EQ(damping.growth, 2);
}

}  // namespace
}  // namespace knotfit
