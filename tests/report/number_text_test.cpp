#include "report/number_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
namespace knotfit::report {
namespace {

TEST(NumberText, HasThreeDigitsATrueMinusAndRaisedPowers) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(0.0012345), "0.00123");
  EXPECT_EQ(number_text(-12.345), "−12.3");
  EXPECT_EQ(number_text(12345), "12345");
  EXPECT_EQ(number_text(1.23456e-7), "1.23 × 10⁻⁷");
  EXPECT_EQ(number_text(9.9999e9), "1.00 × 10¹⁰");
  EXPECT_EQ(number_text(INFINITY), "∞");
}

TEST(NumberText, KeepsATypedFigureShort) {
  EXPECT_EQ(short_number_text(0.5), "0.5");
  EXPECT_EQ(short_number_text(0.0012), "0.0012");
  EXPECT_EQ(short_number_text(1e-7), "1 × 10⁻⁷");
  EXPECT_EQ(short_number_text(1.0 / 3), "0.333");
}

TEST(NumberText, SeparatesThousands) {
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1590), "1590");
  EXPECT_EQ(count_text(17157), "17\u2009157");
  EXPECT_EQ(count_text(2000000), "2\u2009000\u2009000");
}

TEST(Ticks, AreRoundInsideAndNotTooMany) {
  for (double low : {-1.0, 0.0, 0.13, 512050.0, -84.41})
    for (double width : {1.0, 0.336, 1040.0, 7e-5})
      for (int most : {2, 3, 5, 7}) {
        const Ticks t = make_ticks(low, low + width, most);
        ASSERT_EQ(t.at.size(), t.text.size());
        EXPECT_GE(t.at.size(), 1u);
        EXPECT_LE(static_cast<int>(t.at.size()), most);
        for (double x : t.at) {
          EXPECT_GE(x, low);
          EXPECT_LE(x, low + width);
        }
        EXPECT_EQ(std::set<std::string>(t.text.begin(), t.text.end()).size(), t.text.size())
            << "two ticks read alike at " << low << " + " << width;
      }
}

TEST(LogTicks, AreTwoAtLeastInsideAndNotTooMany) {
  for (double low = -12; low < 3; low += 0.037)
    for (double decades : {0.31, 0.5, 0.79, 0.81, 1.7, 2.49, 2.51, 7.0, 40.0}) {
      const std::vector<double> ticks = make_log_ticks(low, low + decades);
      EXPECT_GE(ticks.size(), 2u) << low << " + " << decades;
      EXPECT_LE(ticks.size(), 16u) << low << " + " << decades;
      EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
      for (double x : ticks) {
        EXPECT_GE(std::log10(x), low);
        EXPECT_LE(std::log10(x), low + decades);
      }
    }
}

TEST(Ticks, TakeOutAPowerOfTen) {
  const Ticks t = make_ticks(-0.003, 0.003, 7);
  EXPECT_EQ(t.exponent, -3);
  EXPECT_EQ(t.text.front(), "−3");
  EXPECT_EQ(t.text[3], "0");
  EXPECT_EQ(t.name("error", "m"), "error (10⁻³ m)");
}

TEST(Ticks, TakeOutAnOffsetWhereDigitsWouldNotFit) {
  const Ticks t = make_ticks(1e8, 1e8 + 0.5, 6);
  EXPECT_TRUE(t.name("x").starts_with("x − ")) << t.name("x");
  for (const std::string& text : t.text) EXPECT_LE(text.size(), 6u);
  EXPECT_EQ(make_ticks(5403060, 5404100, 5).name("y"), "y");  // seven digits are read at a glance
}

TEST(Ticks, GiveOneWhereThereIsNoRange) {
  EXPECT_EQ(make_ticks(3, 3, 5).text, std::vector<std::string>{"3.00000"});
  EXPECT_EQ(make_ticks(1, std::nextafter(1, 2), 5).at.size(), 1u);
}

}  // namespace
}  // namespace knotfit::report
