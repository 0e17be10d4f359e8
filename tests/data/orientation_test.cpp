#include "data/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
namespace knotfit {
namespace {

__extension__ typedef __int128 Wide;

// Twice the area of a triangle of whole coordinates, without rounding.
int whole_orientation(const std::int64_t* a, const std::int64_t* b, const std::int64_t* c) {
  const Wide area = Wide{a[0] - c[0]} * (b[1] - c[1]) - Wide{a[1] - c[1]} * (b[0] - c[0]);
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

// Whole coordinates below 2^52 times 2^-52: doubles in [0,1], nearly on one line.
TEST(Orientation, AgreesWithWholeNumbersOnNearlyFlatTriangles) {
  std::mt19937_64 random(5);
  int flat = 0, wrong_by_rounding = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const auto coordinate = [&] { return static_cast<std::int64_t>(random() >> 13); };  // below 2^51
    const std::int64_t a[2] = {coordinate(), coordinate()}, d[2] = {coordinate() >> 20, coordinate() >> 20};
    const auto nudge = [&] { return static_cast<std::int64_t>(random() % 3) - 1; };
    const std::int64_t b[2] = {a[0] + 3 * d[0], a[1] + 3 * d[1]};
    const std::int64_t c[2] = {a[0] + d[0] * 700 + nudge(), a[1] + d[1] * 700 + nudge()};
    const std::int64_t* whole[3] = {a, b, c};
    double real[3][2];
    for (int k = 0; k < 3; ++k)
      for (int x = 0; x < 2; ++x) real[k][x] = std::ldexp(static_cast<double>(whole[k][x]), -52);
    const int exact = whole_orientation(a, b, c);
    flat += exact == 0;
    const double naive = real[0][0] * (real[1][1] - real[2][1]) + real[1][0] * (real[2][1] - real[0][1]) +
                         real[2][0] * (real[0][1] - real[1][1]);
    wrong_by_rounding += (naive > 0 ? 1 : naive < 0 ? -1 : 0) != exact;
    ASSERT_EQ(orientation(real[0], real[1], real[2]), exact) << "trial " << trial;
    ASSERT_EQ(orientation(real[1], real[0], real[2]), -exact) << "trial " << trial;
    ASSERT_EQ(orientation(real[1], real[2], real[0]), exact) << "trial " << trial;
  }
  EXPECT_GT(flat, 500);  // the cases are what they should be
  EXPECT_GT(wrong_by_rounding, 100);
}

TEST(Orientation, SeesTheLeastDoubleBesideALine) {
  const double a[2] = {0, 0}, b[2] = {1, 1};
  const double above[2] = {0.5, std::nextafter(0.5, 1)}, below[2] = {0.5, std::nextafter(0.5, 0)},
               on[2] = {0.5, 0.5};
  EXPECT_EQ(orientation(a, b, above), 1);
  EXPECT_EQ(orientation(a, b, below), -1);
  EXPECT_EQ(orientation(a, b, on), 0);
}

TEST(Orientation, CountsTurnedAndFlatTriangles) {
  const std::vector<double> uv = {0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5};
  const std::vector<std::array<std::int32_t, 3>> faces = {{0, 1, 2}, {0, 2, 1}, {0, 4, 2}, {0, 2, 3}};
  EXPECT_EQ(count_flipped(faces, uv), 2);
}

}  // namespace
}  // namespace knotfit
