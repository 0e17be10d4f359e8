#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
namespace knotfit {
namespace {

using test::expect_throw;

// 60 points of lines 2 to 61; lines 7, 32 and 57 share their parameters.
ParameterizedPoints three_alike(int dimension) {
  ParameterizedPoints points;
  points.dimension = dimension;
  test::Uniform random(1);
  for (Index k = 0; k < 60; ++k) {
    points.uv.insert(points.uv.end(), {random(), random()});
    for (int d = 0; d < dimension; ++d) points.values.push_back(random());
    points.source.push_back(k + 2);
  }
  for (Index k : {5, 30, 55}) points.uv[2 * k] = 0.25, points.uv[2 * k + 1] = 0.75;
  return points;
}

TEST(Duplicates, AreNamedByTheirLines) {
  ParameterizedPoints points = three_alike(1);
  points.values[5] = 1, points.values[30] = 4, points.values[55] = 2;
  for (const char* words :
       {"lines 7, 32 and 57 have equal parameters, u = 0.25 and v = 0.75", "values up to 3 apart",
        "more than twice the tolerance 1.4", "`duplicates = mean`, lowest or highest"})
    expect_throw<InvalidInput>([&] { settle_duplicates(points, DuplicateRule::fail, 1.4); }, words);
  points.map = {"x", "y", 100, 200, 0, 4};
  expect_throw<InvalidInput>([&] { settle_duplicates(points, DuplicateRule::fail, 1.4); },
                             "x = 125 and y = 3");
  points.source.clear();
  expect_throw<InvalidInput>([&] { settle_duplicates(points, DuplicateRule::fail, 1.4); },
                             "points 6, 31 and 56 have");
  points.uv[0] = points.uv[2] = 0.5, points.uv[1] = points.uv[3] = 0.5, points.values[1] = -9;
  expect_throw<InvalidInput>([&] { settle_duplicates(points, DuplicateRule::fail, 1.4); },
                             "points 1 and 2 have");
  expect_throw<InvalidInput>([&] { settle_duplicates(points, DuplicateRule::fail, 1.4); },
                             "(and 1 more such groups)");
}

TEST(Duplicates, WithinTwiceTheToleranceAreKept) {
  ParameterizedPoints points = three_alike(1);
  points.values[5] = 1, points.values[30] = 4, points.values[55] = 2;
  const ParameterizedPoints before = points;
  EXPECT_EQ(settle_duplicates(points, DuplicateRule::fail, 1.5), 0);  // the surface between them meets both
  EXPECT_EQ(settle_duplicates(points, DuplicateRule::fail, 0), 0);    // no tolerance, no failure
  EXPECT_EQ(settle_duplicates(points, DuplicateRule::fail, -1), 0);
  EXPECT_EQ(points.values, before.values);
  EXPECT_EQ(points.uv, before.uv);
}

TEST(Duplicates, AreMeasuredByTheirDistanceInSpace) {
  ParameterizedPoints points = three_alike(3);
  for (Index k : {5, 30, 55}) std::fill_n(points.values.begin() + 3 * k, 3, 0.0);
  points.values[3 * 30] = 3, points.values[3 * 55 + 1] = 4;  // 3, 4 and 5 apart
  EXPECT_EQ(settle_duplicates(points, DuplicateRule::fail, 2.5), 0);
  expect_throw<InvalidInput>([&] { settle_duplicates(points, DuplicateRule::fail, 2.49); },
                             "values up to 5 apart");
}

TEST(Duplicates, OfLargeGroupsAreFound) {
  for (int dimension : {1, 3}) {
    ParameterizedPoints points;
    points.dimension = dimension;
    test::Uniform random(1);
    for (int k = 0; k < 20000; ++k) {
      points.uv.insert(points.uv.end(), {0.5, 0.5});
      for (int d = 0; d < dimension; ++d) points.values.push_back(0.1 * random());
    }
    points.values[static_cast<std::size_t>(777 * dimension)] = 8;
    expect_throw<InvalidInput>([&] { settle_duplicates(points, DuplicateRule::fail, 1); },
                               "points 1, 2, 3, 4, 5, 6, 7, 8 and 19992 more have equal parameters");
    EXPECT_EQ(settle_duplicates(points, DuplicateRule::fail, 4.1), 0);
    EXPECT_EQ(settle_duplicates(points, DuplicateRule::highest, 0), 19999);
    EXPECT_EQ(points.size(), 1);
  }
}

TEST(Duplicates, MergeIntoTheirWeightedMeanAtTheFirstPlace) {
  ParameterizedPoints points = three_alike(3);
  points.weights.assign(60, 1);
  points.weights[30] = 2;
  for (int d = 0; d < 3; ++d)
    points.values[15 + d] = 1e8, points.values[90 + d] = 1e8 + 1, points.values[165 + d] = 1e8 + 6;
  const ParameterizedPoints before = points;
  EXPECT_EQ(settle_duplicates(points, DuplicateRule::mean, 0), 2);
  validate(points);
  ASSERT_EQ(points.size(), 58);
  EXPECT_EQ(points.value(5)[0], 1e8 + 2);  // (0 + 2 1 + 6) / 4
  EXPECT_EQ(points.weights[5], 4);
  EXPECT_EQ(points.source[5], 7);
  EXPECT_EQ(points.source[30], 33);  // the others keep their order
  EXPECT_EQ(points.u(30), before.u(31));
  EXPECT_EQ(points.source[57], 61);
}

TEST(Duplicates, KeepTheLowestOrHighest) {
  for (const bool lowest : {true, false}) {
    ParameterizedPoints points = three_alike(3);
    points.weights.resize(60);
    std::iota(points.weights.begin(), points.weights.end(), 1.0);
    points.values[17] = 0.5, points.values[92] = -7, points.values[167] = 9;  // the last components
    const ParameterizedPoints before = points;
    EXPECT_EQ(settle_duplicates(points, lowest ? DuplicateRule::lowest : DuplicateRule::highest, 0), 2);
    const Index kept = lowest ? 30 : 55;
    for (int d = 0; d < 3; ++d) EXPECT_EQ(points.value(5)[d], before.value(kept)[d]);
    EXPECT_EQ(points.weights[5], before.weights[kept]);
    EXPECT_EQ(points.source[5], before.source[kept]);
    EXPECT_EQ(points.uv[10], 0.25);
    EXPECT_EQ(points.size(), 58);
  }
}

TEST(Duplicates, SettledKeepTheirIndexWhereThereAreNoLines) {
  ParameterizedPoints points = three_alike(1);
  points.source.clear();
  settle_duplicates(points, DuplicateRule::lowest, 0);
  EXPECT_EQ(points.source[29], 30);
  EXPECT_EQ(points.source[30], 32);
  EXPECT_TRUE(points.weights.empty());
}

TEST(Duplicates, SettledLeaveEveryParameterOnce) {
  test::Uniform random(12);
  for (int trial = 0; trial < 30; ++trial) {
    ParameterizedPoints points;
    const Index n = 1 + static_cast<Index>(300 * random());
    for (Index k = 0; k < n; ++k) {
      points.uv.insert(points.uv.end(), {std::floor(12 * random()) / 12, std::floor(12 * random()) / 12});
      points.values.push_back(random());
    }
    std::map<std::pair<double, double>, std::vector<double>> expected;
    std::vector<std::pair<double, double>> order;
    for (Index k = 0; k < n; ++k) {
      auto& values = expected[{points.u(k), points.v(k)}];
      if (values.empty()) order.emplace_back(points.u(k), points.v(k));
      values.push_back(points.values[k]);
    }
    for (DuplicateRule rule : {DuplicateRule::mean, DuplicateRule::lowest, DuplicateRule::highest}) {
      ParameterizedPoints settled = points;
      EXPECT_EQ(settle_duplicates(settled, rule, 0), n - static_cast<Index>(order.size()));
      ASSERT_EQ(settled.size(), static_cast<Index>(order.size()));
      for (Index k = 0; k < settled.size(); ++k) {
        EXPECT_EQ(std::pair(settled.u(k), settled.v(k)), order[k]);
        const auto& v = expected[order[k]];
        if (rule == DuplicateRule::mean) {
          EXPECT_NEAR(settled.values[k], std::accumulate(v.begin(), v.end(), 0.0) / double(v.size()), 1e-15);
          EXPECT_EQ(settled.weight(k), double(v.size()));
        } else {
          EXPECT_EQ(settled.values[k], rule == DuplicateRule::lowest ? *std::min_element(v.begin(), v.end())
                                                                     : *std::max_element(v.begin(), v.end()));
        }
      }
      EXPECT_EQ(settle_duplicates(settled, rule, 0), 0);
    }
  }
}

TEST(Duplicates, OfAMillionPointsAreSettledInTime) {
  ParameterizedPoints points = test::synthetic_points("franke", 500000);
  points.uv.insert(points.uv.end(), points.uv.begin(), points.uv.end());
  points.values.insert(points.values.end(), points.values.begin(), points.values.end());
  EXPECT_EQ(settle_duplicates(points, DuplicateRule::fail, 1e-9), 0);
  EXPECT_EQ(settle_duplicates(points, DuplicateRule::mean, 0), 500000);
}

TEST(Duplicates, AreNotLookedForInPointsThatAreNone) {
  ParameterizedPoints points;
  expect_throw<InvalidInput>([&] { settle_duplicates(points, DuplicateRule::mean, 0); }, "no points");
}

}  // namespace
}  // namespace knotfit
