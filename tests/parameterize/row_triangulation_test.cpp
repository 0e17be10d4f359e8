#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "clouds.h"
#include "knotfit/exceptions.h"
#include "knotfit/parameterize_cloud.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

/// Rows at u by chord length.
struct Rows {
  Points points, uv;
  std::vector<Index> start{0};

  void add(const Points& row, double v) {
    const Index n = static_cast<Index>(row.size()) / 3;
    std::vector<double> length{0};
    for (Index k = 1; k < n; ++k)
      length.push_back(length.back() + std::hypot(row[3 * k] - row[3 * k - 3],
                                                  row[3 * k + 1] - row[3 * k - 2],
                                                  row[3 * k + 2] - row[3 * k - 1]));
    for (Index k = 0; k < n; ++k) uv.insert(uv.end(), {length[k] / length.back(), v});
    points.insert(points.end(), row.begin(), row.end());
    start.push_back(start.back() + n);
  }
};

/// Along x. \param pleat  goes up and down again in it: its chord length shifts what follows against other rows
Points wave_row(int count, double y, bool pleat = false) {
  Points row;
  for (int k = 0; k < count; ++k) {
    const double x = static_cast<double>(k) / (count - 1);
    row.insert(row.end(), {x, y, 0.1 * std::sin(3 * x + y)});
    if (pleat && k == count / 4)
      for (int up = 1; up < 40; ++up)
        row.insert(row.end(), {x, y, 0.1 * std::sin(3 * x + y) + 0.4 * std::sin(0.0785398 * up)});
  }
  return row;
}

TEST(RowsOfPoints, AreJoinedToTheRowsBesideThem) {
  Rows rows;
  Index faces = 0;
  for (int r = 0; r < 15; ++r) rows.add(wave_row(10 + 7 * r % 21, 0.1 * r, r == 7), r / 14.0);
  for (std::size_t r = 1; r + 1 < rows.start.size(); ++r) faces += rows.start[r + 1] - rows.start[r - 1] - 2;
  const CloudMap c = map_rows(rows.points, rows.uv, {.newton = false});
  expect_sound(c);
  EXPECT_TRUE(c.mapped);
  EXPECT_EQ(c.mesh.face_count(), faces);
  EXPECT_EQ(c.coincident + c.lone, 0);
  EXPECT_EQ(c.covered, 1);
  EXPECT_EQ(count_virtual(c), 0);
  // Places near in space are joined, whatever chord length says: away from the pleat no edge is longer than the grid's.
  for (const auto& f : c.mesh.faces)
    for (int k = 0; k < 3; ++k) {
      const double *a = c.mesh.vertex(f[k]), *b = c.mesh.vertex(f[(k + 1) % 3]);
      if (std::max(std::abs(a[2]), std::abs(b[2])) <= 0.1) {
        EXPECT_LT(std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]), 0.25);
      }
    }
}

TEST(RowsOfPoints, ThatAreStrayAreLeftOutByNumber) {
  Rows rows;
  for (int r = 0; r < 12; ++r) {
    Points row = wave_row(12 + r, 0.1 * r);
    if (r == 5)
      for (std::size_t k = 2; k < row.size(); k += 3) row[k] += 3;
    rows.add(row, r / 11.0);
  }
  const CloudMap c = map_rows(rows.points, rows.uv, {.newton = false});
  ASSERT_EQ(c.stray_rows, std::vector<Index>{5});
  EXPECT_EQ(c.lone, 17);
  EXPECT_NE(describe(c).find("row 6 left out"), std::string::npos);
  EXPECT_EQ(c.map.quality.flipped, 0);
}

TEST(RowsOfPoints, GapsInARowAreNoData) {
  Rows rows;
  for (int r = 0; r < 10; ++r) {
    Points row;
    for (int k = 0; k <= 40; ++k)
      if (r < 3 || r > 6 || k < 10 || k > 30) row.insert(row.end(), {0.025 * k, 0.03 * r, 0});
    rows.add(row, r / 9.0);
  }
  const CloudMap c = map_rows(rows.points, rows.uv, {.newton = false});
  EXPECT_GT(count_virtual(c), 3);
  EXPECT_LT(count_virtual(c), 12);
  EXPECT_EQ(c.lone, 0);
}

TEST(RowsOfPoints, PointsAtThePlaceOfTheOneBeforeCountOnce) {
  Rows rows;
  for (int r = 0; r < 6; ++r) {
    Points row = wave_row(12, 0.1 * r);
    if (r == 2) row.insert(row.end(), row.end() - 3, row.end());
    rows.add(row, r / 5.0);
  }
  const CloudMap c = map_rows(rows.points, rows.uv, {.newton = false});
  EXPECT_EQ(c.coincident, 1);
  EXPECT_EQ(c.lone, 0);
}

TEST(RowsOfPoints, AtTheSameVAreTriangulatedByTheirParameters) {
  Rows rows;
  for (int r = 0; r < 6; ++r) rows.add(wave_row(12 + r, 0.1 * r), std::min(r, 4) / 4.0);
  const CloudMap c = map_rows(rows.points, rows.uv), other = triangulate_parameters(rows.points, rows.uv);
  EXPECT_EQ(c.mesh.faces, other.mesh.faces);
  EXPECT_FALSE(c.mapped);
  expect_throw<InvalidInput>([&] { map_rows(rows.points, Points(4, 0.5)); }, "parameters, u and v each");
}

}  // namespace
}  // namespace knotfit::test
