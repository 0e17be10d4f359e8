#include "solve/smoothing_floor.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>
namespace knotfit::test {
namespace {

/// The floors tried until one reaches `enough`.
std::vector<double> tried(double smoothing, double enough) {
  std::vector<double> floors;
  const bool solved = with_smoothing_floor(smoothing, [&](double floor) {
    floors.push_back(floor);
    return floor >= enough;
  });
  EXPECT_EQ(solved, floors.back() >= enough);
  return floors;
}

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST(SmoothingFloor, IsTheOneAskedForWhereThatSuffices) {
  EXPECT_EQ(tried(1e-9, 0), std::vector<double>{1e-9});
  EXPECT_EQ(tried(0, 0), std::vector<double>{0});
}

TEST(SmoothingFloor, IsRaisedAHundredfoldUpToAHundredThousandth) {
  const std::vector<double> floors = tried(1e-9, kNever);
  ASSERT_EQ(floors.size(), 3);
  EXPECT_DOUBLE_EQ(floors[1], 1e-7);
  EXPECT_DOUBLE_EQ(floors[2], 1e-5);
  EXPECT_EQ(tried(1e-9, 1e-8).size(), 2);
}

TEST(SmoothingFloor, OfNothingGoesOnFromTheSecond) {
  const std::vector<double> floors = tried(0, kNever);
  ASSERT_EQ(floors.size(), 5);  // 0, then 1e-12 to 1e-6: a hundred times that is beyond the last
  EXPECT_EQ(floors[1], 1e-12);
  EXPECT_DOUBLE_EQ(floors[4], 1e-6);
  std::vector<double> others;
  with_smoothing_floor(
      0, [&](double floor) { return others.push_back(floor), false; }, 1e-14);
  EXPECT_EQ(others[1], 1e-14);
}

TEST(SmoothingFloor, BeyondTheLastIsTriedOnce) {
  EXPECT_EQ(tried(1e-3, kNever), std::vector<double>{1e-3});
}

}  // namespace
}  // namespace knotfit::test
