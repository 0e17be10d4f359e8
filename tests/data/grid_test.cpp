#include <gtest/gtest.h>

#include <algorithm>

#include "knotfit/points.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

/// A grid of unequal lines, its points in random order.
ParameterizedPoints shuffled_grid(Random& random, int size_u, int size_v) {
  std::vector<double> u, v;
  for (int i = 0; i < size_u; ++i) u.push_back((i + random.uniform(0, 0.9)) / size_u);
  for (int j = 0; j < size_v; ++j) v.push_back((j + random.uniform(0, 0.9)) / size_v);
  std::vector<std::pair<double, double>> places;
  for (double a : u)
    for (double b : v) places.push_back({a, b});
  for (std::size_t k = places.size(); k > 1; --k)
    std::swap(places[k - 1], places[random.integer(0, static_cast<int>(k) - 1)]);
  ParameterizedPoints points;
  for (const auto& [a, b] : places) {
    points.uv.insert(points.uv.end(), {a, b});
    points.values.push_back(10 * a + b);
  }
  return points;
}

TEST(Grid, IsFoundInAnyOrderOfThePoints) {
  Random random;
  for (int k = 0; k < 50; ++k) {
    const int size_u = random.integer(2, 12), size_v = random.integer(2, 12);
    const ParameterizedPoints points = shuffled_grid(random, size_u, size_v);
    const GridLayout grid = find_grid(points);
    ASSERT_EQ(static_cast<int>(grid.u.size()), size_u);
    ASSERT_EQ(static_cast<int>(grid.v.size()), size_v);
    EXPECT_TRUE(std::is_sorted(grid.u.begin(), grid.u.end()));
    EXPECT_TRUE(std::is_sorted(grid.v.begin(), grid.v.end()));
    for (int i = 0; i < size_u; ++i)
      for (int j = 0; j < size_v; ++j) {
        const Index at = grid.point[i * size_v + j];
        EXPECT_EQ(points.u(at), grid.u[i]);
        EXPECT_EQ(points.v(at), grid.v[j]);
      }
  }
}

TEST(Grid, AMissingPointIsNoGrid) {
  Random random;
  for (int drop : {0, 17, 34}) {
    ParameterizedPoints points = shuffled_grid(random, 5, 7);
    points.uv.erase(points.uv.begin() + 2 * drop, points.uv.begin() + 2 * drop + 2);
    points.values.erase(points.values.begin() + drop);
    EXPECT_TRUE(find_grid(points).empty());
  }
}

TEST(Grid, ADoubledPointIsNoGrid) {
  Random random;
  ParameterizedPoints points = shuffled_grid(random, 5, 7);
  points.uv.insert(points.uv.end(), {points.u(3), points.v(3)});
  points.values.push_back(0);
  EXPECT_TRUE(find_grid(points).empty());
}

TEST(Grid, APointInTheSlotOfAnotherIsNoGrid) {
  // As many points as slots, the lines all there: one slot holds two, one none.
  Random random;
  ParameterizedPoints points = shuffled_grid(random, 5, 7);
  points.uv[0] = points.uv[2];
  points.uv[1] = points.uv[3];
  EXPECT_TRUE(find_grid(points).empty());
}

TEST(Grid, APointMovedOffItsLineIsNoGrid) {
  Random random;
  ParameterizedPoints points = shuffled_grid(random, 5, 7);
  points.uv[20] += 1e-15;
  EXPECT_TRUE(find_grid(points).empty());
}

TEST(Grid, OneLineOrNoPointIsNoGrid) {
  Random random;
  EXPECT_TRUE(find_grid({}).empty());
  EXPECT_TRUE(find_grid(shuffled_grid(random, 1, 7)).empty());
  EXPECT_TRUE(find_grid(shuffled_grid(random, 7, 1)).empty());
  EXPECT_TRUE(find_grid(shuffled_grid(random, 1, 1)).empty());
}

}  // namespace
}  // namespace knotfit::test
