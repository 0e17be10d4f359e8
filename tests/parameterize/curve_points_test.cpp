#include "knotfit/curve_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize_curve.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

TEST(CurveParameters, FollowTheRule) {
  const std::vector<double> xy{0, 0, 3, 4, 3, 5, 9, 13};  // chords 5, 1, 10
  const CurvePoints chord = parameterize_curve(xy, 2);
  EXPECT_EQ(chord.size(), 4);
  EXPECT_NEAR(chord.t[1], 5 / 16.0, 1e-15);
  EXPECT_NEAR(chord.t[2], 6 / 16.0, 1e-15);
  EXPECT_EQ(chord.t[0], 0);
  EXPECT_EQ(chord.t[3], 1);
  const double total = std::sqrt(5.0) + 1 + std::sqrt(10.0);
  const CurvePoints centripetal = parameterize_curve(xy, 2, RowSpacing::centripetal);
  EXPECT_NEAR(centripetal.t[1], std::sqrt(5.0) / total, 1e-15);
  EXPECT_NEAR(parameterize_curve(xy, 2, RowSpacing::uniform).t[2], 2 / 3.0, 1e-15);
}

TEST(CurveParameters, GoRoundAClosedCurve) {
  const std::vector<double> square{0, 0, 1, 0, 1, 1, 0, 1};
  std::vector<double> again = square;
  again.insert(again.end(), {0, 0});
  for (const auto& values : {square, again}) {
    const CurvePoints points = parameterize_curve(values, 2, RowSpacing::chord, true);
    EXPECT_TRUE(points.closed);
    EXPECT_EQ(points.t, (std::vector<double>{0, 0.25, 0.5, 0.75}));
    EXPECT_EQ(points.values, square);
    validate(points);
  }
}

TEST(CurveParameters, WorkInAnyDimensionAndSize) {
  const std::vector<double> values{0, 0, 0, 1e200, 0, 0, 1e200, 1e200, 0};
  EXPECT_NEAR(parameterize_curve(values, 3).t[1], 0.5, 1e-15);
  EXPECT_NEAR(parameterize_curve(std::vector<double>{1, 2, 4}, 1).t[1], 1 / 3.0, 1e-15);
}

TEST(CurveParameters, RefuseWhatHasNone) {
  const std::vector<double> one{1, 2}, equal{1, 2, 1, 2, 1, 2}, two{0, 0, 1, 1, 0, 0};
  expect_throw<InvalidInput>([&] { parameterize_curve(one, 2); }, "1 points: a curve needs at least 2");
  expect_throw<InvalidInput>([&] { parameterize_curve(equal, 2); }, "all points are equal");
  expect_throw<InvalidInput>([&] { parameterize_curve(two, 2, RowSpacing::chord, true); },
                             "2 points: a closed curve needs at least 3");
  expect_throw<InvalidInput>([&] { parameterize_curve(equal, 4); },
                             "6 numbers are no points of 4 coordinates");
  std::vector<double> bad = two;
  bad[3] = INFINITY;
  expect_throw<InvalidInput>([&] { parameterize_curve(bad, 2); }, "point 1 has a value that is not finite");
}

SourceData table(std::vector<double> x, std::vector<double> y, std::vector<double> z) {
  PointTable t;
  t.x = std::move(x);
  t.y = std::move(y);
  t.z = std::move(z);
  for (Index k = 0; k < t.size(); ++k) t.line.push_back(k + 2);
  return {"a.csv", "csv", t};
}

TEST(CurveOfData, TakesTablesAndRows) {
  const CurvePoints planar = curve_points_of(table({0, 1, 2}, {0, 0, 1}, {NAN, NAN, NAN}));
  EXPECT_EQ(planar.dimension, 2);
  EXPECT_EQ(planar.source, (std::vector<Index>{2, 3, 4}));
  EXPECT_EQ(curve_points_of(table({0, 1, 2}, {0, 0, 1}, {5, 5, 5})).dimension, 3);
  const CurvePoints graph =
      curve_points_of(table({10, 12, 15}, {1, 2, 3}, {NAN, NAN, NAN}), RowSpacing::chord, false, true);
  EXPECT_EQ(graph.dimension, 1);
  EXPECT_NEAR(graph.t[1], 0.4, 1e-15);
  EXPECT_EQ(graph.x0, 10);
  EXPECT_EQ(graph.x1, 15);
  PointRows rows;
  rows.xyz = {0, 0, 0, 1, 0, 0, NAN, NAN, NAN, 1, 1, 0};
  rows.row_start = {0, 4};
  EXPECT_EQ(curve_points_of({"r.txt", "rows", rows}).size(), 3);
}

TEST(CurveOfData, RefusesWhatIsNoCurve) {
  expect_throw<InvalidInput>([] { curve_points_of({"a.asc", "esri-ascii", Raster{}}); }, "this is no curve");
  PointRows rows;
  rows.xyz = {0, 0, 0, 1, 0, 0};
  rows.row_start = {0, 1, 2};
  expect_throw<InvalidInput>(
      [&] {
        curve_points_of({"r.txt", "rows", rows});
      },
      "2 rows of points: a curve is one");
  expect_throw<InvalidInput>([] { curve_points_of(table({}, {}, {1, 2})); }, "needs columns x and y");
  expect_throw<InvalidInput>(
      [] {
        curve_points_of(table({0, 2, 1}, {1, 2, 3}, {NAN, NAN, NAN}), RowSpacing::chord, false, true);
      },
      "x must increase: point 2 has 1 after 2");
  expect_throw<InvalidInput>(
      [] {
        curve_points_of(table({0, 1}, {1, 2}, {1, 2}), RowSpacing::chord, false, true);
      },
      "x and y alone");
}

TEST(CurvePoints, AreChecked) {
  CurvePoints points = parameterize_curve(std::vector<double>{0, 0, 1, 0, 1, 1}, 2, RowSpacing::chord, true);
  points.function = true;
  expect_throw<InvalidInput>([&] { validate(points); }, "no closed curve");
  points.closed = false;
  expect_throw<InvalidInput>([&] { validate(points); }, "one component, not 2");
  points.function = false;
  points.t[1] = 2;
  EXPECT_THROW(validate(points), InvalidInput);
}

}  // namespace
}  // namespace knotfit::test
