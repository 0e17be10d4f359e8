#include "spline/clamped.h"

#include <gtest/gtest.h>

#include "spline/elevation.h"
#include "support/random_splines.h"
#include "support/sampling.h"
namespace knotfit::test {
namespace {

/// Rounding of one comparison of two surfaces with as large control points.
double rounding(const Surface& a, const Surface& b) {
  return std::sqrt(a.dimension()) * (evaluation_error(a) + evaluation_error(b));
}

TEST(Clamping, LeavesTheSurfaceUnchanged) {
  int open = 0;
  for (const Surface& s : random_surfaces(seed() + 2, 300)) {
    const Surface c = clamped(s);
    EXPECT_TRUE(c.knots_u().is_clamped() && c.knots_v().is_clamped());
    EXPECT_EQ(c.knots_u().breaks(), s.knots_u().breaks());
    EXPECT_EQ(c.knots_v().interior(), s.knots_v().interior());
    EXPECT_LE(c.scale(), s.scale());
    // Each knot inserted rounds a point by 4 eps; up to the degree at each of four ends.
    const double steps = 4.0 * 2 * (s.degree_u() + s.degree_v());
    EXPECT_LE(max_distance(s, c), rounding(s, c) + std::sqrt(s.dimension()) * steps * kEps * s.scale());
    if (s.knots_u().is_clamped() && s.knots_v().is_clamped())
      EXPECT_EQ(c, s);
    else
      ++open;
  }
  EXPECT_GT(open, 100);
}

}  // namespace
}  // namespace knotfit::test
