#include "data/strays.h"

#include <gtest/gtest.h>

#include <cmath>
namespace knotfit::test {
namespace {

using Indices = std::vector<Index>;

/// n points of a wave over the unit square.
std::vector<double> wave(int n) {
  std::vector<double> xyz;
  for (int k = 0; k < n; ++k) {
    const double u = std::fmod(0.618 * k, 1.0), v = std::fmod(0.755 * k, 1.0);
    xyz.insert(xyz.end(), {u, v, 0.1 * std::sin(6 * u)});
  }
  return xyz;
}

TEST(FarStrays, AreThoseThatMakeOnePlaceOfTheOthers) {
  std::vector<double> xyz = wave(100);
  EXPECT_TRUE(far_strays(xyz, 3).empty());
  xyz[3 * 40 + 2] = 900;  // 1000 times the farthest is beyond some 700
  EXPECT_EQ(far_strays(xyz, 3), (Indices{40}));
  xyz[3 * 40 + 2] = 300;
  EXPECT_TRUE(far_strays(xyz, 3).empty());
}

TEST(FarStrays, OfDifferentSizesAreAllFound) {
  std::vector<double> xyz = wave(100);
  xyz[3 * 7] = 1e6;
  xyz[3 * 90 + 1] = -1e12;
  EXPECT_EQ(far_strays(xyz, 3), (Indices{7, 90}));
}

TEST(FarStrays, AreFew) {
  std::vector<double> xyz = wave(100);
  for (int k = 0; k < 6; ++k)
    xyz[static_cast<std::size_t>(3 * k)] += 1e6;  // more than 5 of 100: a part of its own
  EXPECT_TRUE(far_strays(xyz, 3).empty());
  EXPECT_TRUE(far_strays(std::vector<double>{0, 0, 0, 0, 1e9}, 5).empty());
}

TEST(FarStrays, BesideEqualPoints) {
  std::vector<double> xyz(300, 2.5);
  xyz[3 * 20] = 3;
  EXPECT_EQ(far_strays(xyz, 3), (Indices{20}));
  // Heights may all be equal but one.
  EXPECT_TRUE(far_strays(std::vector<double>{0, 0, 0, 0, 0, 0, 1}, 1).empty());
}

}  // namespace
}  // namespace knotfit::test
