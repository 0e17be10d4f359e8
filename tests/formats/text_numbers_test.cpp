#include "formats/text_numbers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

const FileBytes kFile("a.obj", "");

LineNumbers numbers(std::string_view text) {
  return LineNumbers(kFile, {text, 7, text}, text, "vertex");
}

TEST(LineNumbers, AreTakenOneAfterTheOther) {
  LineNumbers line = numbers("  1.5\t-2e3 +.25 word 9 ");
  EXPECT_EQ(line.number(), 1.5);
  EXPECT_EQ(line.number(), -2000);
  EXPECT_EQ(line.number(), 0.25);
  EXPECT_EQ(line.token(), "word");
  EXPECT_FALSE(line.at_end());
  EXPECT_EQ(line.number(), 9);
  EXPECT_TRUE(line.at_end());
}

TEST(LineNumbers, WhatMayBeLeftAsideIsNan) {
  LineNumbers line = numbers("x inf 3");
  EXPECT_TRUE(std::isnan(line.number_or_nan()));
  EXPECT_TRUE(std::isnan(line.number_or_nan()));
  EXPECT_EQ(line.number_or_nan(), 3);
}

TEST(LineNumbers, NameTheLineAndTheWord) {
  const auto bad = [](std::string_view text, const std::string& words) {
    test::expect_throw<FileError>([&] { numbers(text).number(); }, words);
  };
  bad(" ", "a.obj:7: the vertex has too few numbers");
  bad("1,5", "a.obj:7: vertex: \"1,5\" is not a number");
  bad("nan", "\"nan\" is not a finite number");
  bad("1e999", "\"1e999\" is beyond the range of a double");
  bad("1x", "\"1x\" is not a number");
}

}  // namespace
}  // namespace knotfit
