#include "parameterize/table_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit::parameterize {
namespace {

using test::expect_throw;

TEST(PointNames, AreLinesOfTheFileOrNumbersFromOne) {
  const std::vector<Index> line = {7, 9, 12, 20}, none;
  EXPECT_EQ(point_name(line, 2), "line 12");
  EXPECT_EQ(point_name(none, 2), "point 3");
  EXPECT_EQ(point_names(line, std::vector<Index>{1}), "line 9");
  EXPECT_EQ(point_names(line, std::vector<Index>{0, 1, 3}), "lines 7, 9 and 20");
  EXPECT_EQ(point_names(none, std::vector<Index>{0, 3}), "points 1 and 4");
  std::vector<Index> many(12);
  for (Index k = 0; k < 12; ++k) many[k] = k;
  EXPECT_EQ(point_names(none, many), "points 1, 2, 3, 4, 5, 6, 7, 8 and 4 more");
}

TEST(CheckTable, NamesColumnLineAndValue) {
  PointTable table;
  const auto bad = [&](const std::string& words) {
    expect_throw<InvalidInput>([&] { check_table(table); }, words);
  };
  bad("no points: column z is empty");
  table.x = {1, 2}, table.y = {1, 2}, table.z = {1, 2};
  check_table(table);
  table.y = {1};
  bad("column y has 1 values, column z has 2: they must be as many");
  table.y = {1, NAN};
  bad("point 2: y = nan is not a finite number");
  table.y = {1, 2};
  table.line = {4, 9};
  table.weight = {1, 0};
  bad("line 9: weight 0: weights must be positive and finite");
  table.weight.clear();
  table.line = {4};
  bad("1 line numbers for 2 points");
}

TEST(RangeOf, IsTheLeastAndTheLargest) {
  const Range range = range_of({3, -1, 2}, "x");
  EXPECT_EQ(range.low, -1);
  EXPECT_EQ(range.high, 3);
  expect_throw<InvalidInput>([] { range_of({-1e308, 1e308}, "x"); }, "a range that no double can hold");
}

TEST(CheckPlane, RefusesPointsOnALine) {
  std::vector<double> a, b;
  for (int k = 0; k < 30; ++k) a.push_back(k), b.push_back(2 * k + 5);
  EXPECT_THROW(check_plane(a, b, "x", "y", {}), InvalidInput);
  b[17] += 1;
  check_plane(a, b, "x", "y", {});
  EXPECT_THROW(check_plane(a, std::vector<double>(30, 4.0), "x", "y", {}), InvalidInput);
}

TEST(CheckStrays, NamesTheLineOfTheStray) {
  std::vector<double> z;
  for (int k = 0; k < 60; ++k) z.insert(z.end(), {std::fmod(0.618 * k, 1.0), std::fmod(0.755 * k, 1.0), 0.0});
  check_strays(z, 3, {});
  z[3 * 40] = 1e9;
  expect_throw<InvalidInput>([&] { check_strays(z, 3, {}); }, "point 41");
}

}  // namespace
}  // namespace knotfit::parameterize
