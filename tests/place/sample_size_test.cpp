#include "place/sample_size.h"

#include <gtest/gtest.h>
namespace knotfit::test {
namespace {

TEST(SampleSize, OfFewPointsIsAllOfThem) {
  EXPECT_EQ(sample_size(10000, 100, Engine::automatic), 0);
  EXPECT_EQ(sample_size(10000, 100, Engine::sample), 0);
  EXPECT_EQ(sample_size(49999, 100, Engine::automatic), 0);
}

TEST(SampleSize, GrowsWithTheControlPointsExpectedAndNotWithThePoints) {
  EXPECT_EQ(sample_size(1000000, 100, Engine::automatic), 20000);
  EXPECT_EQ(sample_size(100000000, 100, Engine::automatic), 20000);
  EXPECT_EQ(sample_size(1000000, 2000, Engine::automatic), 50000);
  EXPECT_EQ(sample_size(1000000, 20000, Engine::automatic), 0);  // half of the points: no gain
}

TEST(SampleSize, IsForced) {
  EXPECT_EQ(sample_size(1000000, 100, Engine::points), 0);
  EXPECT_EQ(sample_size(30000, 100, Engine::sample), 20000);
}

}  // namespace
}  // namespace knotfit::test
