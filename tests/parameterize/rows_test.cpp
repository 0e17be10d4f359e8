#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize.h"
#include "parameterize/row_parameters.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
namespace knotfit {
namespace {

using test::expect_throw;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr RowSpacing kAll[] = {RowSpacing::chord, RowSpacing::centripetal, RowSpacing::uniform};

// A grid over x = a(u), y = b(v) in a plane: each row is the same, each column too.
PointRows plane_grid(const std::vector<double>& x, const std::vector<double>& y) {
  PointRows rows;
  rows.row_start = {0};
  for (double b : y) {
    for (double a : x) rows.xyz.insert(rows.xyz.end(), {a, b, 0.3});
    rows.row_start.push_back(rows.size());
  }
  return rows;
}

void make_hole(PointRows& rows, Index k) {
  for (int d = 0; d < 3; ++d) rows.xyz[3 * k + d] = kNan;
}

TEST(Rows, OfAGridHaveTheAveragedChordLengths) {
  const PointRows rows = plane_grid({1, 2, 5, 11}, {0, 3, 4});
  const ParameterizedPoints points = parameterize_rows(rows);
  validate(points);
  EXPECT_EQ(points.dimension, 3);
  EXPECT_FALSE(points.height_field);
  EXPECT_EQ(points.values, rows.xyz);
  EXPECT_TRUE(points.source.empty());
  EXPECT_TRUE(points.map.identity());
  const double u[] = {0, 0.1, 0.4, 1}, v[] = {0, 0.75, 1};
  for (Index k = 0; k < 12; ++k) {
    EXPECT_NEAR(points.u(k), u[k % 4], 1e-15);
    EXPECT_NEAR(points.v(k), v[k / 4], 1e-15);
  }
  EXPECT_EQ(find_grid(points).u.size(), 4u);
}

TEST(Rows, FollowTheSpacingsRule) {
  const PointRows rows = plane_grid({0, 1, 5}, {0, 9, 10});
  const ParameterizedPoints roots = parameterize_rows(rows, RowSpacing::centripetal);
  EXPECT_NEAR(roots.u(1), 1.0 / 3, 1e-15);
  EXPECT_NEAR(roots.v(3), 0.75, 1e-15);
  const ParameterizedPoints even = parameterize_rows(rows, RowSpacing::uniform);
  EXPECT_EQ(even.u(1), 0.5);
  EXPECT_EQ(even.v(3), 0.5);
}

// [Piegl97 A9.3] written out: the mean over the rows of each row's own parameters.
TEST(Rows, OfAGridAreTheMeanOfEachRowsOwn) {
  test::Uniform random(3);
  const Index count = 7, columns = 9;
  PointRows rows;
  rows.row_start = {0};
  for (Index r = 0; r < count; ++r) {
    for (Index c = 0; c < columns; ++c)
      rows.xyz.insert(rows.xyz.end(),
                      {static_cast<double>(c) + random(), static_cast<double>(r) + random(), random()});
    rows.row_start.push_back(rows.size());
  }
  std::vector<double> mean(columns, 0);
  for (Index r = 0; r < count; ++r) {
    std::vector<double> own = {0};
    for (Index c = 1; c < columns; ++c) {
      const double* a = &rows.xyz[3 * (r * columns + c - 1)];
      own.push_back(own.back() + std::hypot(a[3] - a[0], a[4] - a[1], a[5] - a[2]));
    }
    for (Index c = 0; c < columns; ++c) mean[c] += own[c] / own.back() / double(count);
  }
  const ParameterizedPoints points = parameterize_rows(rows);
  for (Index c = 0; c < columns; ++c) EXPECT_NEAR(points.u(c), mean[c], 1e-14);
}

TEST(Rows, OfAGridWithHolesKeepTheSpacingOfTheGridWithoutThem) {
  std::vector<double> x = {0}, y = {0};
  test::Uniform random(9);
  for (int i = 1; i < 30; ++i) x.push_back(x.back() + 0.2 + random()), y.push_back(y.back() + 0.1 + random());
  for (RowSpacing spacing : kAll) {
    PointRows rows = plane_grid(x, y);
    // Rows of different length in space: the scale of each must be found.
    for (Index k = 0; k < rows.size(); ++k) rows.xyz[3 * k] *= 1 + 0.1 * static_cast<double>(k / 30);
    const bool shape_kept = spacing == RowSpacing::chord;
    const ParameterizedPoints whole = parameterize_rows(rows, spacing);
    std::vector<Index> left;
    for (Index k = 0; k < rows.size(); ++k) {
      if (random() < 0.3 && k % 29 != 0)
        make_hole(rows, k);
      else
        left.push_back(k);
    }
    const ParameterizedPoints points = parameterize_rows(rows, spacing);
    ASSERT_EQ(points.size(), static_cast<Index>(left.size()));
    for (Index i = 0; i < points.size(); ++i) {
      EXPECT_EQ(points.source[i], left[i] + 1);
      EXPECT_NEAR(points.u(i), whole.u(left[i]), shape_kept ? 1e-11 : 1e-3);
      EXPECT_TRUE(points.v(i) >= 0 && points.v(i) <= 1);
      if (spacing == RowSpacing::uniform) {
        EXPECT_EQ(points.u(i), whole.u(left[i]));
        EXPECT_EQ(points.v(i), whole.v(left[i]));
      }
    }
  }
}

TEST(Rows, OfAGridRunFromItsFirstToItsLastPoint) {
  PointRows rows = plane_grid({0, 1, 2, 3, 4}, {0, 1, 2, 3});
  for (Index k = 0; k < 5; ++k) make_hole(rows, k);          // the first row
  for (Index r = 0; r < 4; ++r) make_hole(rows, 5 * r + 4);  // the last column
  for (Index r = 0; r < 4; ++r) make_hole(rows, 5 * r + 1);  // and one between
  const ParameterizedPoints points = parameterize_rows(rows);
  ASSERT_EQ(points.size(), 9);
  EXPECT_EQ(points.u(0), 0);
  EXPECT_NEAR(points.u(1), 2.0 / 3, 1e-15);  // gaps that no row knows are as wide as the others
  EXPECT_EQ(points.u(2), 1);
  EXPECT_EQ(points.v(0), 0);
  EXPECT_EQ(points.v(8), 1);
  EXPECT_EQ(points.source[0], 6);
}

TEST(Rows, CarryTheLinesOfTheirPoints) {
  PointRows rows = plane_grid({0, 1, 2}, {0, 1});
  rows.line = {1, 2, 3, 5, 6, 7};
  EXPECT_EQ(parameterize_rows(rows).source, rows.line);
  make_hole(rows, 1);
  EXPECT_EQ(parameterize_rows(rows).source, (std::vector<Index>{1, 3, 5, 6, 7}));
}

TEST(Rows, OfDifferentLengthsKeepTheirOwnParameters) {
  PointRows rows;  // three parallel sections, 1 and 3 apart, of 3, 5 and 2 points
  rows.xyz = {0, 0, 0, 1, 0, 0, 4, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 3, 1, 0, 4, 1, 0, 0, 4, 0, 4, 4, 0};
  rows.row_start = {0, 3, 8, 10};
  const ParameterizedPoints points = parameterize_rows(rows);
  validate(points);
  EXPECT_EQ(points.values, rows.xyz);
  const double u[] = {0, 0.25, 1, 0, 0.25, 0.5, 0.75, 1, 0, 1};
  for (Index k = 0; k < 10; ++k) {
    EXPECT_NEAR(points.u(k), u[k], 1e-15);
    EXPECT_NEAR(points.v(k), k < 3 ? 0 : k < 8 ? 0.25 : 1, 1e-15);
  }
  const ParameterizedPoints even = parameterize_rows(rows, RowSpacing::uniform);
  EXPECT_EQ(even.u(1), 0.5);
  EXPECT_EQ(even.v(4), 0.5);
  // Sections at equal u are not upright here, so a little more than 1 / (1 + sqrt 3).
  EXPECT_NEAR(parameterize_rows(rows, RowSpacing::centripetal).v(4), 1 / (1 + std::sqrt(3)), 0.01);
  make_hole(rows, 1);
  EXPECT_EQ(parameterize_rows(rows).size(), 9);
  make_hole(rows, 0);
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "row 1 has 1 points that are no holes");
}

TEST(Rows, DoNotDependOnScaleOrOffset) {
  test::Uniform random(2);
  PointRows rows = plane_grid({0, 1, 2, 3, 4}, {0, 1, 2, 3});
  for (double& x : rows.xyz) x += 0.3 * random();
  const ParameterizedPoints points = parameterize_rows(rows);
  PointRows tiny = rows, far = rows;
  for (double& x : tiny.xyz) x *= 0x1p-400;
  EXPECT_EQ(parameterize_rows(tiny).uv, points.uv);
  for (double& x : far.xyz) x += 1e8;
  const ParameterizedPoints moved = parameterize_rows(far);
  for (Index k = 0; k < points.size(); ++k) EXPECT_NEAR(moved.u(k), points.u(k), 1e-7);  // 1.5e-8 of a unit
}

TEST(Rows, MayMeetInAPole) {
  PointRows rows;  // all rows begin at one point: that column has no length, the others have
  rows.row_start = {0};
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 3; ++c)
      rows.xyz.insert(rows.xyz.end(), {c * std::cos(0.3 * r), c * std::sin(0.3 * r), 0});
    rows.row_start.push_back(rows.size());
  }
  const ParameterizedPoints points = parameterize_rows(rows);
  for (Index k = 0; k < 12; ++k) EXPECT_NEAR(points.v(k), static_cast<double>(k / 3) / 3, 1e-14);
}

TEST(Rows, RefuseWhatHasNoParameters) {
  PointRows rows = plane_grid({0, 1, 2}, {0});
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); },
                             "1 rows of points: a surface needs at least 2");
  expect_throw<InvalidInput>([&] { parameterize_rows(PointRows()); }, "0 rows of points");
  rows = plane_grid({0, 1, 2}, {0, 1});
  rows.row_start = {0, 5, 6};
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "row 2 has 1 points: a row needs at least 2");
  rows.line = {1, 2, 3, 4, 5, 7};
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "row 2 (lines 7 to 7) has 1 points");
  rows.line.pop_back();
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "5 line numbers for 6 points");
  rows.row_start = {0, 4, 3, 6};
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "row starts that do not run from 0");
  rows = plane_grid({0, 1, 2}, {0, 1});
  rows.xyz[7] = INFINITY;
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "point 3: coordinate inf is not finite");
  rows.xyz[7] = 1.7e308;
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "beyond what distances can hold");
}

// The grid of a cone about its axis, `first` the radius of its first row.
PointRows cone(double first, bool turned = false) {
  const double angle[] = {0, 0.2, 0.5, 1.1, 1.3}, height[] = {0, 1, 2.5, 3};
  PointRows rows;
  rows.row_start = {0};
  const auto add = [&](double a, double h) {
    const double r = h == 0 ? first : 0.7 * h;
    rows.xyz.insert(rows.xyz.end(), {r * std::cos(a), r * std::sin(a), h});
  };
  if (turned) {
    for (const double a : angle) {
      for (const double h : height) add(a, h);
      rows.row_start.push_back(rows.size());
    }
  } else {
    for (const double h : height) {
      for (const double a : angle) add(a, h);
      rows.row_start.push_back(rows.size());
    }
  }
  return rows;
}

TEST(Rows, APoleTakesTheParametersOfTheOtherRows) {
  const double height[] = {0, 1.0 / 3, 2.5 / 3, 1};
  // Exactly one point, the rounding of cos(pi / 2) in double and in single precision.
  for (const double first : {0.0, 6e-17, -4.4e-8})
    for (const RowSpacing spacing : {RowSpacing::chord, RowSpacing::centripetal}) {
      const ParameterizedPoints points = parameterize_rows(cone(first), spacing);
      PointRows rest = cone(first);
      rest.xyz.erase(rest.xyz.begin(), rest.xyz.begin() + 15);
      rest.row_start = {0, 5, 10, 15};
      const ParameterizedPoints without = parameterize_rows(rest, spacing);
      for (Index k = 0; k < 20; ++k) {
        EXPECT_NEAR(points.u(k), without.u(k % 5), 1e-14);
        if (spacing == RowSpacing::chord) {
          EXPECT_NEAR(points.v(k), height[k / 5], 1e-7);  // the pole's radius of 4.4e-8
        }
      }
      // The same for a column.
      const ParameterizedPoints turned = parameterize_rows(cone(first, true), spacing);
      for (Index k = 0; k < 20; ++k) {
        EXPECT_NEAR(turned.v(k), points.u(k / 4), 1e-14);
        EXPECT_NEAR(turned.u(k), points.v(5 * (k % 4)), 1e-14);
      }
    }
}

TEST(Rows, APoleAmongRowsOfDifferentLengthsTakesItsNeighboursParameters) {
  PointRows rows = plane_grid({0, 1, 4}, {0, 1, 2});
  for (Index k = 0; k < 3; ++k) rows.xyz[3 * k] = 1;
  rows.xyz.insert(rows.xyz.end(), {5, 2, 0.3});
  rows.row_start = {0, 3, 6, 10};
  const ParameterizedPoints points = parameterize_rows(rows);
  for (Index k = 0; k < 3; ++k) {
    EXPECT_EQ(points.u(k), points.u(k + 3));
    EXPECT_EQ(points.v(k), 0);
  }
  EXPECT_EQ(points.u(1), 0.25);
}

TEST(Rows, RefuseRowsOfNoLength) {
  PointRows rows = plane_grid({0, 1, 2}, {0, 1, 2});
  for (Index k = 0; k < 9; ++k) rows.xyz[3 * k] = 1;
  for (RowSpacing spacing : {RowSpacing::chord, RowSpacing::centripetal})
    expect_throw<InvalidInput>([&] { parameterize_rows(rows, spacing); }, "the rows have no length");
  EXPECT_EQ(parameterize_rows(rows, RowSpacing::uniform).size(), 9);
  rows.row_start = {0, 4, 6, 9};  // rows of different lengths
  for (Index k = 0; k < 9; ++k) rows.xyz[3 * k + 1] = 1;
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); },
                             "row 1 has no length: all its points are equal");
  rows = plane_grid({0, 1, 2}, {5, 5});
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "no length from row to row");
  rows = plane_grid({0, 1, 2, 3}, {5, 5});
  rows.xyz.erase(rows.xyz.begin() + 15, rows.xyz.begin() + 18);
  rows.row_start = {0, 4, 7};
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "all rows are equal");
}

TEST(Rows, RefuseGridsOfHoles) {
  PointRows rows = plane_grid({0, 1, 2}, {0, 1});
  for (Index k = 0; k < 3; ++k) make_hole(rows, k);
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "lie in a single row or column");
  for (Index k = 3; k < 6; ++k) make_hole(rows, k);
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "every point of the rows is a hole");
  rows = plane_grid({0, 1, 2}, {0, 1, 2});
  for (Index k : {1, 3, 4, 5, 7}) make_hole(rows, k);
  expect_throw<InvalidInput>([&] { parameterize_rows(rows); }, "neither a hole, differ");
}

}  // namespace
}  // namespace knotfit
