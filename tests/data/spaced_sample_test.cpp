#include "data/spaced_sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using Points = std::vector<double>;

/// A wave over the unit square, ten times as dense in its left half.
Points uneven_sheet(int count) {
  Random random(3);
  Points p;
  for (int k = 0; k < count; ++k) {
    const double x = k % 11 < 10 ? 0.5 * random.unit() : 0.5 + 0.5 * random.unit(), y = random.unit();
    p.insert(p.end(), {x, y, 0.2 * std::sin(4 * x + y)});
  }
  return p;
}

double distance(const Points& p, Index a, Index b) {
  return std::hypot(p[3 * a] - p[3 * b], p[3 * a + 1] - p[3 * b + 1], p[3 * a + 2] - p[3 * b + 2]);
}

TEST(SpacedSample, FewEnoughPointsAreAllKept) {
  const Points p = uneven_sheet(50);
  std::vector<Index> all(50);
  std::iota(all.begin(), all.end(), Index{0});
  EXPECT_EQ(spaced_sample(p, 50), all);
  EXPECT_EQ(spaced_sample(p, 1000), all);
}

TEST(SpacedSample, NeverMoreThanAskedForAndNotFarFewer) {
  const Points p = uneven_sheet(20000);
  for (const Index most : {1, 2, 7, 100, 1000, 5000}) {
    const std::vector<Index> sample = spaced_sample(p, most);
    EXPECT_LE(static_cast<Index>(sample.size()), most);
    EXPECT_GE(2.5 * static_cast<double>(sample.size()), static_cast<double>(most)) << most;
    EXPECT_TRUE(std::is_sorted(sample.begin(), sample.end()));
    EXPECT_EQ(std::set<Index>(sample.begin(), sample.end()).size(), sample.size());
    EXPECT_TRUE(sample.front() >= 0 && sample.back() < 20000);
  }
}

TEST(SpacedSample, IsEvenInSpaceWhereThePointsAreNot) {
  const Points p = uneven_sheet(40000);
  const std::vector<Index> sample = spaced_sample(p, 1000);
  const auto left = std::count_if(sample.begin(), sample.end(), [&](Index k) { return p[3 * k] < 0.5; });
  const double share = static_cast<double>(left) / static_cast<double>(sample.size());
  EXPECT_NEAR(share, 0.5, 0.05);  // of the points ten elevenths are there
}

TEST(SpacedSample, EveryPointHasOneOfTheSampleNear) {
  const Points p = uneven_sheet(20000);
  const std::vector<Index> sample = spaced_sample(p, 500);
  // Some 500 cells with points over an area of about 1.1: none wider than 0.06.
  for (Index k = 0; k < 20000; k += 7) {
    double least = INFINITY;
    for (const Index s : sample) least = std::min(least, distance(p, k, s));
    EXPECT_LT(least, 0.06 * std::sqrt(3.0));
  }
}

TEST(SpacedSample, ReachesAsFarAsTheCloud) {
  const Points p = uneven_sheet(40000);
  const std::vector<Index> sample = spaced_sample(p, 1000);  // cells of 0.03 or so
  const auto reach = [&](const auto& points, int c, double sign) {
    double far = -INFINITY;
    for (const Index k : points) far = std::max(far, sign * p[3 * k + c]);
    return far;
  };
  std::vector<Index> all(40000);
  std::iota(all.begin(), all.end(), Index{0});
  for (int c = 0; c < 2; ++c)
    for (const double sign : {-1.0, 1.0}) EXPECT_LT(reach(all, c, sign) - reach(sample, c, sign), 1e-3);
}

TEST(SpacedSample, PointsAtOnePlaceAreOne) {
  const Points p(3 * 40, 7.0);
  EXPECT_EQ(spaced_sample(p, 10).size(), 1U);
}

TEST(SpacedSample, DependsOnThePointsAlone) {
  const Points p = uneven_sheet(5000);
  EXPECT_EQ(spaced_sample(p, 300), spaced_sample(p, 300));
}

}  // namespace
}  // namespace knotfit::test
