#include "base/narrow.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

constexpr Index kMost = std::numeric_limits<int>::max(), kLeast = std::numeric_limits<int>::min();

TEST(Narrow, KeepsEveryCountThatFits) {
  for (Index count : {Index{0}, Index{1}, Index{-1}, kMost, kLeast}) EXPECT_EQ(narrow(count), count);
}

TEST(Narrow, SaysWhichCountOverflowsAndWhatToDo) {
  expect_throw<InvalidInput>([] { narrow(kMost + 1); }, "a count of 2147483648");
  expect_throw<InvalidInput>([] { narrow(kMost + 1); }, "ask for fewer control points");
  expect_throw<InvalidInput>([] { narrow(kLeast - 1); }, "-2147483649");
}

}  // namespace
}  // namespace knotfit::test
