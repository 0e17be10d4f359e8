#include "verify/gap_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "knotfit/threads.h"
#include "support/synthetic.h"
#include "verify/local_reference.h"
namespace knotfit::verify {
namespace {

using Places = std::vector<std::array<double, 2>>;

Places places_of(const ParameterizedPoints& points, Index count, unsigned long long seed = 1) {
  const DistinctPoints distinct = distinct_points(points);
  return gap_places(plain_neighbours(distinct), count, seed);
}

TEST(GapPlaces, AreInTheSquareAndApart) {
  const Places places = places_of(test::synthetic_points("franke"), 1000);
  ASSERT_EQ(places.size(), 1000u);
  Index border = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (double x : places[i]) EXPECT_TRUE(x >= 0 && x <= 1);
    border += places[i][0] == 0 || places[i][0] == 1 || places[i][1] == 0 || places[i][1] == 1;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]),
                0.25 / std::sqrt(10000.0));
  }
  EXPECT_GT(border, 200);
  EXPECT_LT(border, 800);
}

TEST(GapPlaces, LieFartherFromThePointsThanRandomOnes) {
  const ParameterizedPoints points = test::synthetic_points("franke");
  const DistinctPoints distinct = distinct_points(points);
  const Neighbours neighbours = plain_neighbours(distinct);
  std::vector<double> at_places, at_random;
  for (const auto& p : gap_places(neighbours, 1000, 1)) at_places.push_back(neighbours.gap(p[0], p[1]));
  test::Uniform random(5);
  for (int k = 0; k < 1000; ++k) {
    const double u = random();
    at_random.push_back(neighbours.gap(u, random()));
  }
  std::sort(at_places.begin(), at_places.end());
  std::sort(at_random.begin(), at_random.end());
  EXPECT_GT(at_places[500], 1.5 * at_random[500]);
}

TEST(GapPlaces, FindAGapWideForItsSurroundings) {
  ParameterizedPoints points;
  for (double const x : test::synthetic_points("franke", 10000).uv) points.uv.push_back(x);
  // A gap of 1.5 spacings about (0.61, 0.37): wide, and no hole yet.
  ParameterizedPoints cut;
  for (Index k = 0; k < points.size(); ++k)
    if (std::hypot(points.u(k) - 0.61, points.v(k) - 0.37) > 0.015)
      cut.uv.insert(cut.uv.end(), {points.u(k), points.v(k)}), cut.values.push_back(0);
  const Places places = places_of(cut, 1000);
  const bool seen =
      std::ranges::any_of(places, [](const auto& p) { return std::hypot(p[0] - 0.61, p[1] - 0.37) < 0.008; });
  EXPECT_TRUE(seen);
}

TEST(GapPlaces, AreNotSpentOnAHole) {
  ParameterizedPoints points;
  test::Uniform random(2);
  while (points.size() < 10000) {
    const double u = random(), v = random();
    if (std::hypot(u - 0.5, v - 0.5) > 0.25)
      points.uv.insert(points.uv.end(), {u, v}), points.values.push_back(0);
  }
  Index inside = 0, near_rim = 0;
  for (const auto& p : places_of(points, 1000)) {
    inside += std::hypot(p[0] - 0.5, p[1] - 0.5) < 0.19;
    near_rim += std::hypot(p[0] - 0.5, p[1] - 0.5) < 0.25;
  }
  EXPECT_LT(inside, 20);
  EXPECT_LT(near_rim, 250);
}

TEST(GapPlaces, SpreadOverAGridWhoseGapsAreAllAlike) {
  ParameterizedPoints points;
  for (int i = 0; i <= 150; ++i)
    for (int j = 0; j <= 150; ++j)
      points.uv.insert(points.uv.end(), {i / 150.0, j / 150.0}), points.values.push_back(0);
  Index quarter[4] = {};
  for (const auto& p : places_of(points, 1000)) ++quarter[(p[0] > 0.5 ? 2 : 0) + (p[1] > 0.5)];
  for (Index count : quarter) EXPECT_GT(count, 150);
}

TEST(GapPlaces, AreNoMoreThanAsked) {
  EXPECT_TRUE(places_of(test::synthetic_points("franke", 10), 0).empty());
  EXPECT_EQ(places_of(test::synthetic_points("franke", 1), 17).size(), 17u);
  EXPECT_LE(places_of(test::synthetic_points("franke", 30), 1000000).size(), 1000000u);
}

TEST(GapPlaces, AreTheSameForOneAndTwoThreads) {
  const ParameterizedPoints points = test::synthetic_points("franke", 50000);
  set_thread_count(1);
  const Places one = places_of(points, 500);
  set_thread_count(2);
  EXPECT_EQ(places_of(points, 500), one);
  EXPECT_NE(places_of(points, 500, 2), one);
  set_thread_count(0);
}

}  // namespace
}  // namespace knotfit::verify
