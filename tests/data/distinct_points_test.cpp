#include "data/distinct_points.h"

#include <gtest/gtest.h>

#include <map>

#include "support/synthetic.h"
#include "support/two_threads.h"
namespace knotfit {
namespace {

// Many points on few parameters, by a map.
TEST(DistinctPoints, AreTheWeightedMeansOfAMap) {
  for (Index n : {50, 500, 60000}) {
    test::Uniform random(7);
    ParameterizedPoints points;
    points.dimension = 2;
    const double nodes = n < 1000 ? 6 : 200;
    for (Index k = 0; k < n; ++k) {
      points.uv.push_back(std::floor(random() * nodes) / nodes);
      points.uv.push_back(std::floor(random() * nodes) / nodes);
      points.values.push_back(random()), points.values.push_back(1e8 + random());
      points.weights.push_back(0.5 + random());
    }
    struct Sum {
      double weight = 0, a = 0, b = 0;
    };
    std::map<std::pair<double, double>, Sum> expected;
    double mean = 0;
    for (Index k = 0; k < n; ++k) {
      Sum& s = expected[{points.u(k), points.v(k)}];
      const double w = points.weight(k);
      s.weight += w, s.a += w * points.value(k)[0], s.b += w * (points.value(k)[1] - 1e8);
      mean += w / static_cast<double>(n);
    }
    const DistinctPoints found = distinct_points(points);
    ASSERT_EQ(found.size(), static_cast<Index>(expected.size()));
    ASSERT_EQ(found.of.size(), static_cast<std::size_t>(n));
    for (Index i = 0; i < n; ++i) {
      EXPECT_EQ(found.u[found.of[i]], points.u(i));
      EXPECT_EQ(found.v[found.of[i]], points.v(i));
    }
    Index k = 0;
    for (const auto& [uv, s] : expected) {  // a map is sorted by (u, v) too
      EXPECT_EQ(found.u[k], uv.first);
      EXPECT_EQ(found.v[k], uv.second);
      EXPECT_NEAR(found.value(k)[0], s.a / s.weight, 1e-13);
      EXPECT_NEAR(found.value(k)[1] - 1e8, s.b / s.weight, 3e-8);  // an ulp of 1e8 or two
      EXPECT_NEAR(found.weights[k], s.weight / mean, 1e-11 * s.weight / mean);
      ++k;
    }
  }
}

TEST(DistinctPoints, WithoutRepeatsAreThePointsThemselves) {
  const ParameterizedPoints points = test::synthetic_points("torus", 50000);
  const DistinctPoints found = distinct_points(points);
  EXPECT_EQ(found.size(), 50000);
  EXPECT_TRUE(found.weights.empty());
  EXPECT_GT(found.strip_start.size(), 3u);
  EXPECT_EQ(found.strip_start.back(), 50000);
  EXPECT_TRUE(std::is_sorted(found.u.begin(), found.u.end()));
}

TEST(DistinctPoints, OfOneParameterAreOnePoint) {
  ParameterizedPoints points;
  for (int k = 0; k < 40000; ++k)
    points.uv.insert(points.uv.end(), {0.5, 0.25}), points.values.push_back(k % 2);
  const DistinctPoints found = distinct_points(points);
  ASSERT_EQ(found.size(), 1);
  EXPECT_NEAR(found.values[0], 0.5, 1e-12);
  EXPECT_NEAR(found.weights[0], 40000, 1e-8);
}

TEST(DistinctPoints, OfHugeValuesStayFinite) {
  ParameterizedPoints points;
  points.uv = {0.5, 0.5, 0.5, 0.5};
  points.values = {1.7e308, 1.7e308};
  EXPECT_EQ(distinct_points(points).values[0], 1.7e308);
}

TEST(DistinctPoints, SameBitsForOneAndTwoThreads) {
  ParameterizedPoints points = test::synthetic_points("franke", 100000);
  for (double& x : points.uv) x = std::round(x * 400) / 400;
  const auto [one, two] = test::on_one_and_two_threads([&] { return distinct_points(points); });
  EXPECT_EQ(one.u, two.u);
  EXPECT_EQ(one.v, two.v);
  EXPECT_EQ(one.values, two.values);
  EXPECT_EQ(one.weights, two.weights);
}

}  // namespace
}  // namespace knotfit
