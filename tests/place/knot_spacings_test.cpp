#include "place/knot_spacings.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "support/expect_gradient.h"
namespace knotfit {
namespace {

TEST(KnotSpacings, ComeBackAsTheKnots) {
  const std::vector<double> knots = {0.25, 0.5, 0.5, 0.75};  // a double knot is one unknown
  const KnotSpacings spacings(knots);
  EXPECT_EQ(spacings.length, (std::vector<double>{0.25, 0.25, 0.25, 0.25}));
  EXPECT_EQ(spacings.multiplicity, (std::vector<int>{1, 2, 1}));
  EXPECT_EQ(spacings.knot_count(), 4u);
  EXPECT_EQ(spacings.knots(), knots);
}

TEST(KnotSpacings, MoveByLogarithmsAndFillTheInterval) {
  const KnotSpacings spacings(std::vector<double>{0.2, 0.6});
  const std::vector<double> step = {std::log(2.0), 0, std::log(0.5)};
  const KnotSpacings moved = spacings.moved(step.data(), 0);
  EXPECT_NEAR(moved.length[0] / moved.length[1], 2 * 0.2 / 0.4, 1e-14);
  EXPECT_NEAR(moved.length[2] / moved.length[1], 0.5, 1e-14);
  EXPECT_NEAR(std::accumulate(moved.length.begin(), moved.length.end(), 0.0), 1, 1e-15);
}

TEST(KnotSpacings, ChainIsTheDerivativeOfEveryKnot) {
  const KnotSpacings spacings(std::vector<double>{0.2, 0.6, 0.6, 0.7});
  std::vector<double> matrix(4 * 4, 0.0);
  spacings.chain(matrix, 0, 0, 4);
  for (std::size_t knot = 0; knot < 4; ++knot)
    test::expect_gradient(
        [&](const std::vector<double>& a) { return spacings.moved(a.data(), 0).knots()[knot]; },
        std::vector<double>(4, 0.0), std::span(matrix).subspan(4 * knot, 4));
}

TEST(RaiseLengths, KeepsEverySpanAtItsLeast) {
  std::vector<double> length = {1e-9, 0.3, 0.3, 0.4 - 1e-9};
  raise_lengths(length, 0.2);
  EXPECT_DOUBLE_EQ(length[0], 0.05);
  EXPECT_DOUBLE_EQ(length[1], length[2]);
  EXPECT_NEAR(std::accumulate(length.begin(), length.end(), 0.0), 1, 1e-15);
}

}  // namespace
}  // namespace knotfit
