#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
namespace knotfit {
namespace {

using test::expect_throw;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Raster small_raster() {
  Raster raster;
  raster.columns = 3, raster.rows = 2;
  raster.x0 = 10, raster.y0 = 20, raster.dx = 2, raster.dy = 4;
  raster.z = {1, 2, 3, 4, 5, 6};
  return raster;
}

TEST(HeightFieldOfARaster, RunsFromFirstToLastCellCentre) {
  const ParameterizedPoints points = parameterize_height_field(small_raster());
  EXPECT_EQ(points.dimension, 1);
  EXPECT_TRUE(points.height_field);
  EXPECT_EQ(points.map, (ParameterMap{"x", "y", 11, 15, 22, 26}));
  // Row by row from the north, where v = 1.
  EXPECT_EQ(points.uv, (std::vector<double>{0, 1, 0.5, 1, 1, 1, 0, 0, 0.5, 0, 1, 0}));
  EXPECT_EQ(points.values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_TRUE(points.source.empty());
  EXPECT_EQ(points.map.from_u(0.5), small_raster().x(1));
  EXPECT_EQ(points.map.from_v(1), small_raster().y(0));
}

TEST(HeightFieldOfARaster, LeavesHolesOutAndKeepsTheCellsNumbers) {
  Raster raster = small_raster();
  raster.z[0] = raster.z[4] = kNan;
  const ParameterizedPoints points = parameterize_height_field(raster);
  EXPECT_EQ(points.values, (std::vector<double>{2, 3, 4, 6}));
  EXPECT_EQ(points.source, (std::vector<Index>{2, 3, 4, 6}));
  EXPECT_EQ(points.map, parameterize_height_field(small_raster()).map);  // of the grid, not of its data
  EXPECT_EQ(points.u(0), 0.5);
}

TEST(HeightFieldOfARaster, FillsAGrid) {
  Raster raster;
  raster.columns = 403, raster.rows = 344;
  raster.x0 = -84.41375, raster.y0 = 36.44625, raster.dx = raster.dy = 0.000833333;
  raster.z.assign(403 * 344, 1);
  const GridLayout grid = find_grid(parameterize_height_field(raster));
  EXPECT_EQ(grid.u.size(), 403u);
  EXPECT_EQ(grid.v.size(), 344u);
}

TEST(HeightFieldOfARaster, RefusesWhatIsNoGrid) {
  Raster raster = small_raster();
  raster.rows = 1, raster.z.resize(3);
  expect_throw<InvalidInput>([&] { parameterize_height_field(raster); },
                             "1 rows and 3 columns: a surface needs at least 2");
  raster = small_raster(), raster.z.pop_back();
  expect_throw<InvalidInput>([&] { parameterize_height_field(raster); }, "with 5 heights");
  raster = small_raster(), raster.dy = 0;
  expect_throw<InvalidInput>([&] { parameterize_height_field(raster); }, "must be positive and finite");
  raster = small_raster(), raster.x0 = INFINITY;
  expect_throw<InvalidInput>([&] { parameterize_height_field(raster); }, "corners are not finite");
  raster = small_raster(), raster.x0 = 1e17;
  expect_throw<InvalidInput>([&] { parameterize_height_field(raster); }, "below the rounding of the corner");
  raster = small_raster(), raster.z[5] = -INFINITY;
  expect_throw<InvalidInput>([&] { parameterize_height_field(raster); },
                             "row 2, column 3 of the grid: height -inf");
  raster = small_raster(), raster.z.assign(6, kNan);
  expect_throw<InvalidInput>([&] { parameterize_height_field(raster); }, "without a cell that has data");
}

PointTable scattered(Index n, double x0, double y0, double width, double height) {
  PointTable table;
  test::Uniform random(4);
  for (Index k = 0; k < n; ++k) {
    table.x.push_back(x0 + width * random());
    table.y.push_back(y0 + height * random());
    table.z.push_back(random());
    table.line.push_back(k + 2);
  }
  return table;
}

TEST(HeightFieldOfPoints, FillsTheSquareWithTheirBox) {
  PointTable table = scattered(1000, -3, 7, 20, 0.5);
  table.weight.assign(1000, 2);
  const ParameterizedPoints points = parameterize_height_field(table);
  validate(points);
  EXPECT_TRUE(points.height_field);
  EXPECT_EQ(points.dimension, 1);
  EXPECT_EQ(points.values, table.z);
  EXPECT_EQ(points.weights, table.weight);
  EXPECT_EQ(points.source, table.line);
  EXPECT_EQ(points.map.name_u, "x");
  double low = 1, high = 0;
  for (Index k = 0; k < 1000; ++k) {
    low = std::min(low, points.u(k)), high = std::max(high, points.u(k));
    EXPECT_NEAR(points.map.from_u(points.u(k)), table.x[k], 1e-13);
    EXPECT_NEAR(points.map.from_v(points.v(k)), table.y[k], 1e-13);
  }
  EXPECT_EQ(low, 0);
  EXPECT_EQ(high, 1);
}

TEST(HeightFieldOfPoints, KeepsMillimetresAtHugeCoordinates) {
  PointTable table = scattered(1000, 1e8, -3e8, 5, 5);
  const ParameterizedPoints points = parameterize_height_field(table);
  // The differences are exact, so that a parameter is off by a rounding of its own.
  for (Index k = 0; k < 1000; ++k) EXPECT_NEAR(points.map.from_u(points.u(k)), table.x[k], 3e-8);
  for (Index k = 1; k < 1000; ++k)
    EXPECT_NEAR((points.u(k) - points.u(0)) * (points.map.u1 - points.map.u0), table.x[k] - table.x[0],
                1e-14);
}

TEST(HeightFieldOfPoints, NeedsXAndY) {
  PointTable table;
  table.z = {1, 2, 3};
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); },
                             "`height_field` fits z over (x, y), and there are no x and y columns");
}

TEST(HeightFieldOfPoints, RefusesPointsThatSpanNoPlane) {
  PointTable table = scattered(50, 0, 0, 1, 1);
  std::fill(table.x.begin(), table.x.end(), 3);
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); },
                             "all 50 points have x = 3: they lie on one straight line in (x, y)");
  std::fill(table.y.begin(), table.y.end(), -2);
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); },
                             "all 50 points have x = 3 and y = -2");
  table = scattered(50, 0, 0, 1, 1);
  std::fill(table.y.begin(), table.y.end(), 0.25);
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); }, "all 50 points have y = 0.25");
  for (double offset : {0.0, 1e8})
    for (double slope : {0.5, -3.0, 1e-3}) {
      table = scattered(50, offset, 0, 2, 1);
      for (Index k = 0; k < 50; ++k) table.y[k] = slope * (table.x[k] - offset);
      expect_throw<InvalidInput>([&] { parameterize_height_field(table); },
                                 "50 points: they lie on one straight line in (x, y)");
    }
  // Six digits of a straight line, as in a text file.
  table = scattered(50, 1, 0, 2, 1);
  for (Index k = 0; k < 50; ++k) {
    table.y[k] = std::round((4 - table.x[k]) / 2 * 1e5) / 1e5;
    table.x[k] = std::round(table.x[k] * 1e5) / 1e5;
  }
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); }, "straight line");
  // A narrow strip is a plane all the same.
  table = scattered(50, 1, 0, 2, 1);
  for (Index k = 0; k < 50; ++k) table.y[k] = table.x[k] + 1e-3 * table.y[k];
  EXPECT_EQ(parameterize_height_field(table).size(), 50);
  PointTable one = scattered(1, 0, 0, 1, 1);
  expect_throw<InvalidInput>([&] { parameterize_height_field(one); }, "they span no surface");
}

TEST(HeightFieldOfPoints, NamesTheLineOfWhatIsNoNumber) {
  PointTable table = scattered(20, 0, 0, 1, 1);
  table.z[16] = kNan;
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); },
                             "line 18: z = nan is not a finite number");
  table = scattered(20, 0, 0, 1, 1);
  table.x[3] = INFINITY;
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); }, "line 5: x = inf");
  table = scattered(20, 0, 0, 1, 1);
  table.weight.assign(20, 1), table.weight[7] = 0;
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); },
                             "line 9: weight 0: weights must be positive");
  table.line.clear();
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); }, "point 8: weight 0");
  table = scattered(20, 0, 0, 1, 1);
  table.y.pop_back();
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); },
                             "column y has 19 values, column z has 20");
  table = scattered(20, 0, 0, 1, 1);
  table.line.pop_back();
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); }, "19 line numbers for 20 points");
  expect_throw<InvalidInput>([&] { parameterize_height_field(PointTable()); }, "no points");
  table = scattered(20, 0, 0, 1, 1);
  table.x[0] = -1.7e308, table.x[1] = 1.7e308;
  expect_throw<InvalidInput>([&] { parameterize_height_field(table); }, "a range that no double can hold");
}

}  // namespace
}  // namespace knotfit
