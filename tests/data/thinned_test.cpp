#include "data/thinned.h"

#include <gtest/gtest.h>

#include <algorithm>
namespace knotfit::test {
namespace {

ParameterizedPoints row(int n) {
  ParameterizedPoints points;
  points.dimension = 2;
  points.map.u1 = 7;
  for (int k = 0; k < n; ++k) {
    points.uv.insert(points.uv.end(), {static_cast<double>(k) / n, 0.5});
    points.values.insert(points.values.end(), {1.0 * k, -1.0 * k});
    points.weights.push_back(k + 1);
    points.source.push_back(k + 100);
  }
  return points;
}

TEST(Thinned, FewEnoughPointsAreAllKept) {
  const ParameterizedPoints points = row(10), same = thinned(points, 10);
  EXPECT_EQ(same.uv, points.uv);
  EXPECT_EQ(same.values, points.values);
  EXPECT_EQ(same.weights, points.weights);
}

TEST(Thinned, EveryKthIsKeptWithItsValuesAndWeight) {
  const ParameterizedPoints points = row(10), few = thinned(points, 4);  // every third
  ASSERT_EQ(few.size(), 4);
  EXPECT_EQ(few.dimension, 2);
  EXPECT_EQ(few.map, points.map);
  EXPECT_EQ(few.values, (std::vector<double>{0, 0, 3, -3, 6, -6, 9, -9}));
  EXPECT_EQ(few.weights, (std::vector<double>{1, 4, 7, 10}));
  for (Index k = 0; k < few.size(); ++k) EXPECT_EQ(few.u(k), points.u(3 * k));
}

TEST(Thinned, NeverMoreThanAskedFor) {
  for (int n = 1; n < 50; ++n)
    for (Index most = 1; most < 60; ++most) {
      const Index size = thinned(row(n), most).size();
      EXPECT_LE(size, most);
      EXPECT_GE(2 * size, std::min<Index>(n, most));  // the least stride: no more than half too few
    }
}

TEST(Picked, AreThePointsOfTheseIndicesInTheirOrder) {
  const ParameterizedPoints points = row(10);
  const std::vector<Index> index{7, 2};
  const ParameterizedPoints few = picked(points, index);
  EXPECT_EQ(few.uv, (std::vector<double>{0.7, 0.5, 0.2, 0.5}));
  EXPECT_EQ(few.values, (std::vector<double>{7, -7, 2, -2}));
  EXPECT_EQ(few.weights, (std::vector<double>{8, 3}));
  EXPECT_EQ(few.map, points.map);
  EXPECT_TRUE(few.source.empty());
}

}  // namespace
}  // namespace knotfit::test
