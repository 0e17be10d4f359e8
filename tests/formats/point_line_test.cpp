#include "formats/point_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace knotfit {
namespace {

/// The numbers of a line; empty where something is wrong with it. A column that is left out is -1.
std::vector<double> parsed(std::string_view text, std::size_t columns, Separator separator,
                           std::size_t left_out = 99) {
  std::vector<double> values(columns, -1);
  std::vector<double*> into;
  for (std::size_t k = 0; k < columns; ++k) into.push_back(k == left_out ? nullptr : &values[k]);
  const TextLine line{trimmed(text), 1, text};
  return parse_line(line, into, separator) ? values : std::vector<double>{};
}

TEST(PointLine, TakesANumberAColumn) {
  const std::vector<double> wanted = {1, -2.5, 3e4};
  EXPECT_EQ(parsed("1 -2.5   3e4", 3, Separator::blanks), wanted);
  EXPECT_EQ(parsed("1, -2.5 ,3e4", 3, Separator::comma), wanted);
  EXPECT_EQ(parsed("1;-2.5;3e4;", 3, Separator::semicolon), wanted) << "a separator at the end";
  EXPECT_EQ(parsed("\"1\",-2.5,\" 3e4 \"", 3, Separator::comma), wanted) << "quotes";
  EXPECT_EQ(parsed("1 -2.5 3e4 # said", 3, Separator::blanks), wanted) << "a comment";
}

TEST(PointLine, PassesOverColumnsLeftOut) {
  EXPECT_EQ(parsed("1,red,3", 3, Separator::comma, 1), (std::vector<double>{1, -1, 3}));
}

TEST(PointLine, WhatIsMissingIsNan) {
  for (const std::string_view text : {"1,nan,3", "1,,3"}) {
    const std::vector<double> values = parsed(text, 3, Separator::comma);
    ASSERT_EQ(values.size(), 3u) << text;
    EXPECT_TRUE(std::isnan(values[1])) << text;
    EXPECT_EQ(values[2], 3) << text;
  }
  const std::vector<double> first = parsed("\t2\t3", 3, Separator::tab);
  ASSERT_EQ(first.size(), 3u) << "an empty cell at the begin counts where tabs part them";
  EXPECT_TRUE(std::isnan(first[0]));
}

TEST(PointLine, SaysWhatCannotBe) {
  EXPECT_TRUE(parsed("1 2", 3, Separator::blanks).empty()) << "too few";
  EXPECT_TRUE(parsed("1 2 3 4", 3, Separator::blanks).empty()) << "too many";
  EXPECT_TRUE(parsed("1,2x,3", 3, Separator::comma).empty());
  EXPECT_TRUE(parsed("1 2,3", 2, Separator::blanks).empty());
}

}  // namespace
}  // namespace knotfit
