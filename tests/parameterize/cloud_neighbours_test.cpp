#include "parameterize/cloud_neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "clouds.h"
#include "knotfit/parameterize_cloud.h"
#include "parameterize/cloud_lines.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

TEST(NeighboursAcrossLines, HoldTheLinesBeside) {
  const int columns = 60, rows = 20;
  for (const double ratio : {4.0, 6.0, 7.0, 10.0, 30.0}) {
    SCOPED_TRACE(ratio);
    const Points p = wave_grid(columns, rows, 1, ratio, 0.3, 1000);
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
  for (const Points& p : {spread, line, wave_grid(30, 30, 1, 1), wave_grid(30, 30, 1, 2)}) {
    const cloud::NeighbourLists lists = cloud::neighbours_across_lines(p, 16),
                                nearest = cloud::nearest_neighbours(p, 3, 16);
    EXPECT_EQ(lists.index, nearest.index);
    EXPECT_EQ(lists.squared, nearest.squared);
  }
}

}  // namespace
}  // namespace knotfit::test
