#include "knotfit/grid_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "clouds.h"
#include "knotfit/openings.h"
#include "knotfit/parameterize_cloud.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using std::numbers::pi;

/// Points as a height field over [0, 10] x [0, 5] whose parameters are the places.
ParameterizedPoints heights(const Points& p) {
  ParameterizedPoints points;
  points.height_field = true;
  points.map = {.name_u = "x", .name_v = "y", .u0 = 0, .u1 = 10, .v0 = 0, .v1 = 10};
  for (std::size_t k = 0; k < p.size(); k += 3) {
    points.uv.insert(points.uv.end(), {p[k], p[k + 1]});
    points.values.push_back(p[k + 2]);
  }
  return points;
}

TEST(GridSupport, IsTheDataWithoutItsOpeningsAndWhatIsBeyond) {
  Random random;
  Points p = sheet_with_windows(random, 4000, {{0.5, 0.5, 0.2}});
  // Nothing right of x = 0.8.
  Points left;
  for (std::size_t k = 0; k < p.size(); k += 3)
    if (p[k] < 0.8) left.insert(left.end(), &p[k], &p[k] + 3);
  Raster grid{.columns = 100, .rows = 100, .x0 = 0, .y0 = 0, .dx = 0.1, .dy = 0.1, .z = {}};
  const std::vector<char> support = grid_support(heights(left), grid);
  const double spacing = 10 / std::sqrt(4000 / (1 - pi * 0.04));
  Index with = 0, without = 0;
  for (Index r = 0; r < 100; ++r)
    for (Index c = 0; c < 100; ++c) {
      const double x = grid.x(c), y = grid.y(r), from_middle = std::hypot(x - 5, y - 5);
      const bool has = support[r * 100 + c] != 0;
      if (from_middle < 2 - spacing || x > 8 + 3 * spacing) {
        EXPECT_FALSE(has) << x << " " << y;
        ++without;
      }
      // Along the border the points are ragged.
      if (from_middle > 2 + 2 * spacing && x < 8 - 2 * spacing && std::min({x, y, 10 - y}) > 2 * spacing) {
        EXPECT_TRUE(has) << x << " " << y;
        ++with;
      }
    }
  EXPECT_GT(with, 4000);
  EXPECT_GT(without, 1500);
}

TEST(GridSupport, OfAnEvenSheetIsEveryNode) {
  Random random;
  Raster grid{.columns = 80, .rows = 80, .x0 = 0, .y0 = 0, .dx = 0.125, .dy = 0.125, .z = {}};
  Points p;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) p.insert(p.end(), {i / 40.0, j / 40.0, 0.0});
  const std::vector<char> of_grid = grid_support(heights(p), grid);
  EXPECT_EQ(std::count(of_grid.begin(), of_grid.end(), 0), 0);
  const std::vector<char> at_random = grid_support(heights(sheet_with_windows(random, 3000, {})), grid);
  // A node in a thousand is farther than 2.5 spacings from all points, or in a bare corner.
  EXPECT_LT(std::count(at_random.begin(), at_random.end(), 0), 20);
}

}  // namespace
}  // namespace knotfit::test
