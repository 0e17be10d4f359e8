#include "data/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "data/distinct_points.h"
#include "support/synthetic.h"
namespace knotfit {
namespace {

std::vector<double> brute_force(const DistinctPoints& points, double u, double v, std::size_t k) {
  std::vector<double> squared;
  for (Index i = 0; i < points.size(); ++i)
    squared.push_back(test::square(points.u[i] - u) + test::square(points.v[i] - v));
  std::sort(squared.begin(), squared.end());
  squared.resize(std::min(k, squared.size()));
  return squared;
}

void expect_nearest(const ParameterizedPoints& data, std::size_t k) {
  const DistinctPoints points = distinct_points(data);
  const Neighbours neighbours = plain_neighbours(points);
  test::Uniform random(3);
  std::vector<std::uint32_t> index(k);
  std::vector<double> squared(k);
  for (int trial = 0; trial < 40; ++trial) {
    double u = random(), v = random();
    if (trial % 4 == 0) u = trial % 8 == 0;  // the border
    const auto count = static_cast<std::size_t>(neighbours.nearest(u, v, index, squared));
    const std::vector<double> expected = brute_force(points, u, v, k);
    ASSERT_EQ(count, expected.size());
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(squared[i], expected[i]);
      EXPECT_EQ(squared[i], test::square(points.u[index[i]] - u) + test::square(points.v[index[i]] - v));
      for (std::size_t j = 0; j < i; ++j) EXPECT_NE(index[i], index[j]);
    }
    EXPECT_EQ(neighbours.gap(u, v), std::sqrt(expected[0]));
  }
}

TEST(Neighbours, AreThoseOfABruteForceSearch) {
  for (Index n : {1, 10, 79, 3000, 70000}) expect_nearest(test::synthetic_points("franke", n), 80);
}

// From 129 on they are kept in a heap.
TEST(Neighbours, ManyAreFoundInAnotherWay) {
  for (Index n : {100, 129, 3000, 70000})
    for (std::size_t k : {128, 129, 700}) expect_nearest(test::synthetic_points("franke", n), k);
}

TEST(Neighbours, OfGridsRowsAndClustersToo) {
  ParameterizedPoints grid, rows, cluster = test::synthetic_points("franke", 40000);
  for (int i = 0; i <= 200; ++i)
    for (int j = 0; j <= 200; ++j)
      grid.uv.insert(grid.uv.end(), {i / 200.0, j / 200.0}), grid.values.push_back(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 15000; ++j)
      rows.uv.insert(rows.uv.end(), {i / 2.0, j / 14999.0}), rows.values.push_back(0);
  for (double& x : cluster.uv) x = std::pow(x, 12);
  for (const ParameterizedPoints& points : {grid, rows, cluster}) expect_nearest(points, 60);
}

}  // namespace
}  // namespace knotfit
