#include "place/shares.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/random_splines.h"
namespace knotfit::test {
namespace {

/// The mass below x, by adding spans up.
double mass_below(const std::vector<double>& breaks, const std::vector<double>& mass, double x) {
  double sum = 0;
  for (std::size_t s = 0; s < mass.size(); ++s) {
    const double part = (x - breaks[s]) / (breaks[s + 1] - breaks[s]);
    sum += std::clamp(part, 0.0, 1.0) * mass[s];
  }
  return sum;
}

TEST(EqualShares, CutTheMassIntoEqualParts) {
  Random random;
  for (int k = 0; k < 200; ++k) {
    const int spans = random.integer(1, 30), count = random.integer(0, 40);
    std::vector<double> breaks = random_numbers(random, spans - 1);
    for (double& x : breaks) x = (x + 1) / 2;
    std::sort(breaks.begin(), breaks.end());
    breaks = with_ends(breaks);
    std::vector<double> mass;
    for (int s = 0; s < spans; ++s) mass.push_back(random.log_uniform(1e-3, 1));
    const double total = std::accumulate(mass.begin(), mass.end(), 0.0);
    const std::vector<double> knots = equal_shares(breaks, mass, count);
    ASSERT_EQ(static_cast<int>(knots.size()), count);
    for (int i = 0; i < count; ++i) {
      EXPECT_NEAR(mass_below(breaks, mass, knots[i]), total * (i + 1) / (count + 1), 1e-12 * total);
      EXPECT_GT(knots[i], i > 0 ? knots[i - 1] : 0.0);
    }
  }
}

TEST(EqualShares, JumpOverSpansWithoutMass) {
  const std::vector<double> breaks{0, 0.25, 0.5, 0.75, 1}, mass{0, 1, 0, 1};
  const std::vector<double> knots = equal_shares(breaks, mass, 3);
  EXPECT_NEAR(knots[0], 0.375, 4 * kEps);
  EXPECT_NEAR(knots[2], 0.875, 4 * kEps);
  EXPECT_GE(knots[1], 0.5);
  EXPECT_LE(knots[1], 0.75);
}

TEST(UniformKnots, AreEquallySpaced) {
  EXPECT_TRUE(uniform_knots(0).empty());
  EXPECT_EQ(uniform_knots(3), (std::vector<double>{0.25, 0.5, 0.75}));
  EXPECT_EQ(with_ends(uniform_knots(1)), (std::vector<double>{0, 0.5, 1}));
}

RC_GTEST_PROP(WidenSpans, LeavesNoSpanShorterThanItsShare, ()) {
  // Thousandths: coincident knots, and knots on 0 and 1, come often.
  auto places = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1001));
  const double relative = *rc::gen::element(0.0001, 0.01, 0.1, 0.5, 0.9);
  std::vector<double> knots;
  for (int place : places) knots.push_back(place / 1000.0);
  std::vector<double> sorted = knots;
  std::sort(sorted.begin(), sorted.end());
  widen_spans(knots, relative);
  RC_ASSERT(knots.size() == places.size());
  const std::vector<double> breaks = with_ends(knots);
  const double floor = relative / static_cast<double>(knots.size() + 1);
  bool wide = true;
  const std::vector<double> before = with_ends(sorted);
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
    // Positions are sums of lengths: a rounding each.
    RC_ASSERT(breaks[s + 1] - breaks[s] >= floor - static_cast<double>(breaks.size()) * kEps);
    wide = wide && before[s + 1] - before[s] >= floor;
  }
  if (wide) RC_ASSERT(knots == sorted);  // nothing to do, nothing done
}

TEST(WidenSpans, SpreadsKnotsThatAllCoincide) {
  for (double place : {0.0, 0.5, 1.0}) {
    std::vector<double> knots(9, place);
    widen_spans(knots, 0.01);
    const std::vector<double> breaks = with_ends(knots);
    for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
      EXPECT_GE(breaks[s + 1] - breaks[s], 0.001 - 9 * kEps);
  }
}

TEST(WidenSpans, ShrinksTheOthersInProportion) {
  std::vector<double> knots{0.2, 0.2, 0.6};
  widen_spans(knots, 0.4);  // the span of no length becomes 0.1, the others 0.9 of what they were
  EXPECT_NEAR(knots[0], 0.18, 4 * kEps);
  EXPECT_NEAR(knots[1], 0.28, 4 * kEps);
  EXPECT_NEAR(knots[2], 0.64, 4 * kEps);
}

TEST(WidenSpans, FollowsAChainOfSpansThatNeedItOneAfterTheOther) {
  // Each widening shrinks the next shortest below the floor: 40 in turn.
  const double floor = 0.9 / 100;
  std::vector<double> lengths(99, 0.0);
  double factor = 1, used = 0;
  for (int s = 0; s < 40; ++s) {
    lengths[s] = floor * factor;
    factor *= 1.001;
  }
  for (double x : lengths) used += x;
  std::vector<double> knots;
  double at = 0;
  for (int s = 0; s < 99; ++s) {
    if (s >= 40) lengths[s] = (1 - used) / 60;
    knots.push_back(at += lengths[s]);
  }
  knots[0] = 0;  // the first step
  widen_spans(knots, 0.9);
  const std::vector<double> breaks = with_ends(knots);
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
    EXPECT_GE(breaks[s + 1] - breaks[s], floor - 100 * kEps);
}

}  // namespace
}  // namespace knotfit::test
