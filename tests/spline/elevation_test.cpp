#include "spline/elevation.h"

#include <gtest/gtest.h>

#include "knotfit/exceptions.h"
#include "spline/clamped.h"
#include "spline/splitting.h"
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

TEST(Splitting, PiecesAreTheSurface) {
  Random random;
  for (const Surface& s : random_surfaces(seed() + 3, 200, Ends::clamped)) {
    std::vector<double> cuts = s.knots_u().breaks();
    cuts.pop_back();
    if (!cuts.empty()) cuts.erase(cuts.begin());
    const double fresh = random_parameter(random, s.knots_u());
    if (fresh > s.knots_u().first() && s.knots_u().multiplicity(fresh) == 0) cuts.push_back(fresh);
    std::sort(cuts.begin(), cuts.end());
    const std::vector<Surface> pieces = split_u(s, cuts);
    ASSERT_EQ(pieces.size(), cuts.size() + 1);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const Surface& piece = pieces[k];
      EXPECT_EQ(piece.knots_u().first(), k == 0 ? s.knots_u().first() : cuts[k - 1]);
      EXPECT_EQ(piece.knots_u().last(), k == cuts.size() ? s.knots_u().last() : cuts[k]);
      EXPECT_TRUE(piece.knots_u().interior().empty());
      const double a = piece.knots_u().first(), b = piece.knots_u().last();
      for (int n = 1; n < 8; ++n) {
        const double u = a + (b - a) * n / 8, v = random_parameter(random, s.knots_v());
        if (!(u > a && u < b)) continue;
        std::vector<double> x(static_cast<std::size_t>(s.dimension())), y = x;
        evaluate(s, u, v, x);
        evaluate(piece, u, v, y);
        const double insertions = 4.0 * s.degree_u() * s.degree_u() * kEps * s.scale();
        for (int d = 0; d < s.dimension(); ++d)
          EXPECT_NEAR(x[static_cast<std::size_t>(d)], y[static_cast<std::size_t>(d)],
                      evaluation_error(s) + evaluation_error(piece) + insertions);
      }
    }
  }
}

TEST(Splitting, NeighboursShareTheirBorderUnlessTheSurfaceJumps) {
  Random random;
  const std::vector<double> interior = {0.25, 0.5, 0.5, 0.75, 0.75, 0.75};
  const KnotVector u = KnotVector::clamped(2, interior), v = KnotVector::uniform(3, 2);
  const Surface s(u, v, 3, random_numbers(random, u.size() * v.size() * 3));
  const std::vector<double> cuts = {0.25, 0.5, 0.75};
  const std::vector<Surface> p = split_u(s, cuts);
  ASSERT_EQ(p.size(), 4U);
  const auto shared = [&](std::size_t k) {
    for (Index j = 0; j < v.size(); ++j)
      for (int d = 0; d < 3; ++d)
        if (p[k].control_point(p[k].size_u() - 1, j)[d] != p[k + 1].control_point(0, j)[d]) return false;
    return true;
  };
  EXPECT_TRUE(shared(0));
  EXPECT_TRUE(shared(1));
  EXPECT_FALSE(shared(2));
}

}  // namespace
}  // namespace knotfit::test
