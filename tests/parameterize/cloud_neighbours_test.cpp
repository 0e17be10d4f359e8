#include "parameterize/cloud_neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "knotfit/parameterize_cloud.h"
#include "parameterize/cloud_lines.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using Points = std::vector<double>;

/// A wave over a grid of columns x rows with these steps, turned by an angle, from some place on.
Points grid(int columns, int rows, double dx, double dy, double angle = 0, double far = 0,
            bool flat = false) {
  Points p;
  const double c = std::cos(angle), s = std::sin(angle), height = 0.15 * std::min(columns * dx, rows * dy);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = i * dx, y = j * dy;
      const double z = flat ? 0 : height * std::sin(3.0 * i / columns) * std::cos(2.0 * j / rows);
      p.insert(p.end(), {far + c * x - s * y, far + s * x + c * y, z});
    }
  return p;
}

TEST(NeighboursAcrossLines, HoldTheLinesBeside) {
  const int columns = 60, rows = 20;
  for (const double ratio : {4.0, 6.0, 7.0, 10.0, 30.0}) {
    SCOPED_TRACE(ratio);
    const Points p = grid(columns, rows, 1, ratio, 0.3, 1000);
    const cloud::NeighbourLists lists = cloud::neighbours_across_lines(p, 16);
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const int k = columns * j + i;
        const std::set<std::uint32_t> near(lists.of(k), lists.of(k) + 16);
        EXPECT_EQ(near.size(), 16u);
        for (int di = -1; di <= 1; ++di)
          for (int dj = -1; dj <= 1; ++dj)
            if ((di != 0 || dj != 0) && i + di >= 0 && i + di < columns && j + dj >= 0 && j + dj < rows) {
              EXPECT_TRUE(near.contains(static_cast<std::uint32_t>(k + di + columns * dj))) << i << " " << j;
            }
        for (int n = 0; n < 16; ++n) {
          double square = 0;
          for (int c = 0; c < 3; ++c)
            square += std::pow(p[3 * lists.of(k)[n] + static_cast<std::size_t>(c)] - p[3 * k + c], 2);
          EXPECT_NEAR(lists.squared[static_cast<std::size_t>(16 * k + n)], square, 1e-9 * square);
          if (n > 0) {
            EXPECT_GE(lists.squared[16 * k + n], lists.squared[16 * k + n - 1]);
          }
        }
      }
  }
}

TEST(NeighboursAcrossLines, AreTheNearestWherePointsSpreadOrNoOtherLineIs) {
  Random random;
  Points spread, line;
  for (int k = 0; k < 3000; ++k) {
    spread.insert(spread.end(), {random.unit(), random.unit(), 0.01 * random.unit()});
    line.insert(line.end(), {0.01 * k, 5.0, 2.0});
  }
  for (const Points& p : {spread, line, grid(30, 30, 1, 1), grid(30, 30, 1, 2)}) {
    const cloud::NeighbourLists lists = cloud::neighbours_across_lines(p, 16),
                                nearest = cloud::nearest_neighbours(p, 3, 16);
    EXPECT_EQ(lists.index, nearest.index);
    EXPECT_EQ(lists.squared, nearest.squared);
  }
}

}  // namespace
}  // namespace knotfit::test
