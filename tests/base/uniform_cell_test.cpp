#include "base/uniform_cell.h"

#include <gtest/gtest.h>
namespace knotfit::test {
namespace {

TEST(UniformCell, HoldsItsLowerEndAndTheLastItsUpperToo) {
  EXPECT_EQ(uniform_cell(0, 4), 0);
  EXPECT_EQ(uniform_cell(0.2499, 4), 0);
  EXPECT_EQ(uniform_cell(0.25, 4), 1);
  EXPECT_EQ(uniform_cell(0.999, 4), 3);
  EXPECT_EQ(uniform_cell(1, 4), 3);
  EXPECT_EQ(uniform_cell(1, 1), 0);
}

}  // namespace
}  // namespace knotfit::test
