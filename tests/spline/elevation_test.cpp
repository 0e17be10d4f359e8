#include "spline/elevation.h"

#include <gtest/gtest.h>

#include "knotfit/exceptions.h"
#include "spline/clamped.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
#include "support/sampling.h"
namespace knotfit::test {
namespace {

/// Rounding of one comparison of two surfaces with as large control points.
double rounding(const Surface& a, const Surface& b) {
  return std::sqrt(a.dimension()) * (evaluation_error(a) + evaluation_error(b));
}

/// Without jumps along u.
Surface without_jumps(Random& random, int dimension) {
  const int p = random.integer(1, kMaxDegree);
  KnotVector u = random_knots(random, p, Ends::clamped, 8, p), v = random_knots(random, 2, Ends::clamped, 3);
  std::vector<double> net = random_numbers(random, u.size() * v.size() * dimension);
  return Surface(std::move(u), std::move(v), dimension, std::move(net));
}

TEST(DegreeElevation, LeavesTheSurfaceUnchanged) {
  Random random;
  for (int k = 0; k < 300; ++k) {
    const Surface s = without_jumps(random, random.integer(1, 3));
    const int degree = random.integer(s.degree_u(), kMaxDegree);
    const Surface e = elevated_u(s, degree);
    ASSERT_EQ(e.degree_u(), degree);
    EXPECT_EQ(e.knots_u().breaks(), s.knots_u().breaks());
    for (const double knot : s.knots_u().interior())  // the same continuity
      EXPECT_EQ(e.knots_u().multiplicity(knot) - degree, s.knots_u().multiplicity(knot) - s.degree_u());
    // Means of convex combinations: they stay in the hull, and round by a few eps a step.
    EXPECT_LE(e.scale(), s.scale() * (1 + 64 * kEps));
    const double steps = 8.0 * degree * (degree - s.degree_u());
    EXPECT_LE(max_distance(s, e), rounding(s, e) + std::sqrt(s.dimension()) * steps * kEps * s.scale());
  }
}

TEST(DegreeElevation, KeepsTheBitsOfBothBorders) {
  Random random;
  for (int k = 0; k < 50; ++k) {
    const Surface s = without_jumps(random, 3);
    const Surface e = elevated_u(s, kMaxDegree);
    for (Index j = 0; j < s.size_v(); ++j)
      for (int d = 0; d < 3; ++d) {
        EXPECT_EQ(e.control_point(0, j)[d], s.control_point(0, j)[d]);
        EXPECT_EQ(e.control_point(e.size_u() - 1, j)[d], s.control_point(s.size_u() - 1, j)[d]);
      }
  }
}

// Two straight lines meet in a fold; as a cubic each has its points at thirds.
TEST(DegreeElevation, OfAPolygonPutsPointsAtThirds) {
  const Surface s(KnotVector::uniform(1, 1), KnotVector::uniform(1, 0), 1, {0, 0, 3, 3, 0, 0});
  const Surface e = elevated_u(s, 3);
  const std::vector<double> heights = {0, 1, 2, 3, 2, 1, 0};
  ASSERT_EQ(e.size_u(), 7);
  for (Index i = 0; i < 7; ++i)
    EXPECT_NEAR(e.control_point(i, 0)[0], heights[static_cast<std::size_t>(i)], 1e-15);
}

TEST(DegreeElevation, RefusesWhatItCannotDo) {
  const Surface s(KnotVector::uniform(2, 1), KnotVector::uniform(1, 0), 1, std::vector<double>(8, 0.0));
  expect_throw<InvalidInput>([&] { elevated_u(s, 1); }, "degree 2 cannot be raised to 1");
  expect_throw<InvalidInput>([&] { elevated_u(s, 10); }, "degree 2 cannot be raised to 10");
  expect_throw<InvalidInput>([&] { elevated_u(Surface(), 3); }, "is empty");
  const std::vector<double> jump = {0.5, 0.5, 0.5};
  const Surface torn(KnotVector::clamped(2, jump), KnotVector::uniform(1, 0), 1,
                     std::vector<double>(12, 0.0));
  expect_throw<InvalidInput>([&] { elevated_u(torn, 3); }, "jumps at 0.5");
  const Surface open(KnotVector(2, {0, 1, 2, 3, 4, 5}), KnotVector::uniform(1, 0), 1,
                     std::vector<double>(6, 0.0));
  expect_throw<InvalidInput>([&] { elevated_u(open, 3); }, "is not clamped");
}

}  // namespace
}  // namespace knotfit::test
