#include <gtest/gtest.h>

#include <limits>

#include "knotfit/exceptions.h"
#include "knotfit/surface.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
#include "support/sampling.h"
namespace knotfit::test {
namespace {

/// A knot of the domain's inside: often one that is there already, if it may repeat.
double knot_to_insert(Random& random, const KnotVector& t) {
  const std::vector<double> interior = t.interior();
  if (!interior.empty() && random.integer(0, 1) == 0) {
    const double x =
        interior[static_cast<std::size_t>(random.integer(0, static_cast<int>(interior.size()) - 1))];
    if (t.multiplicity(x) <= t.degree()) return x;
  }
  return t.first() + (t.last() - t.first()) * (0.01 + 0.98 * random.unit());
}

std::vector<double> knots_to_insert(Random& random, const KnotVector& t, int count) {
  std::vector<double> added;
  for (int k = 0; k < count; ++k) {
    const double x = knot_to_insert(random, t);
    if (t.multiplicity(x) + std::count(added.begin(), added.end(), x) <= t.degree()) added.push_back(x);
  }
  std::sort(added.begin(), added.end());
  return added;
}

// New control points are convex combinations of two old ones [Piegl97 5.2], one rounding a de
// Boor step; then both surfaces are evaluated.
double bound(const Surface& s, int degree) {
  return std::sqrt(s.dimension()) * (4 * degree * kEps * s.scale() + 2 * evaluation_error(s));
}

TEST(KnotInsertion, LeavesTheSurfaceUnchanged) {
  Random random;
  for (const Surface& s : random_surfaces(seed(), 200)) {
    const Surface in_u = insert_knot_u(s, knot_to_insert(random, s.knots_u()));
    EXPECT_EQ(in_u.size_u(), s.size_u() + 1);
    EXPECT_LE(max_distance(s, in_u), bound(s, s.degree_u()));
    const Surface in_v = insert_knot_v(s, knot_to_insert(random, s.knots_v()));
    EXPECT_EQ(in_v.size_v(), s.size_v() + 1);
    EXPECT_LE(max_distance(s, in_v), bound(s, s.degree_v()));
  }
}

TEST(KnotInsertion, MakesConvexCombinationsOfTwoNeighbours) {
  Random random;
  for (const Surface& s : random_surfaces(seed() + 1, 200)) {
    const Surface in_u = insert_knot_u(s, knot_to_insert(random, s.knots_u()));
    for (Index i = 0; i < in_u.size_u(); ++i)
      for (Index j = 0; j < in_u.size_v(); ++j)
        for (int d = 0; d < s.dimension(); ++d) {
          const double a = s.control_point(std::max<Index>(i - 1, 0), j)[d];
          const double b = s.control_point(std::min(i, s.size_u() - 1), j)[d],
                       c = in_u.control_point(i, j)[d];
          const double rounding = 3 * kEps * std::max(std::abs(a), std::abs(b));
          EXPECT_GE(c, std::min(a, b) - rounding);
          EXPECT_LE(c, std::max(a, b) + rounding);
        }
  }
}

TEST(KnotRefinement, LeavesTheSurfaceUnchanged) {
  Random random;
  for (const Surface& s : random_surfaces(seed() + 2, 200)) {
    const std::vector<double> u = knots_to_insert(random, s.knots_u(), random.integer(0, 20));
    const Surface in_u = refine_u(s, u);
    EXPECT_EQ(in_u.size_u(), s.size_u() + static_cast<Index>(u.size()));
    // A point is blended at most degree times, whatever the number of knots: those with one
    // function's support wholly among new knots are fixed.
    EXPECT_LE(max_distance(s, in_u), bound(s, s.degree_u()));
    const std::vector<double> v = knots_to_insert(random, s.knots_v(), random.integer(0, 20));
    const Surface in_v = refine_v(s, v);
    EXPECT_EQ(in_v.size_v(), s.size_v() + static_cast<Index>(v.size()));
    EXPECT_LE(max_distance(s, in_v), bound(s, s.degree_v()));
  }
}

TEST(KnotRefinement, IsInsertionOneByOne) {
  Random random;
  for (const Surface& s : random_surfaces(seed() + 3, 100)) {
    const std::vector<double> added = knots_to_insert(random, s.knots_v(), 10);
    const Surface refined = refine_v(s, added);
    Surface one_by_one = s;
    for (double x : added) one_by_one = insert_knot_v(one_by_one, x);
    ASSERT_EQ(refined.knots_v(), one_by_one.knots_v());
    const double rounding = 4 * s.degree_v() * static_cast<double>(added.size() + 1) * kEps * s.scale();
    for (std::size_t k = 0; k < refined.net().size(); ++k)
      EXPECT_NEAR(refined.net()[k], one_by_one.net()[k], rounding);
  }
}

TEST(KnotRefinement, StaysWithinTheOldControlPoints) {
  Random random;
  for (const Surface& s : random_surfaces(seed() + 4, 100)) {
    const Surface refined = refine_u(s, knots_to_insert(random, s.knots_u(), 15));
    for (int d = 0; d < s.dimension(); ++d) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (std::size_t k = static_cast<std::size_t>(d); k < s.net().size();
           k += static_cast<std::size_t>(s.dimension())) {
        low = std::min(low, s.net()[k]);
        high = std::max(high, s.net()[k]);
      }
      const double rounding = 4 * s.degree_u() * kEps * s.scale();
      for (std::size_t k = static_cast<std::size_t>(d); k < refined.net().size();
           k += static_cast<std::size_t>(s.dimension())) {
        EXPECT_GE(refined.net()[k], low - rounding);
        EXPECT_LE(refined.net()[k], high + rounding);
      }
    }
  }
}

TEST(KnotRefinement, ByNothingChangesNothing) {
  const Surface s = random_surfaces(seed(), 1)[0];
  EXPECT_EQ(refine_u(s, {}), s);
  EXPECT_EQ(refine_v(s, {}), s);
}

TEST(KnotRefinement, ToFullMultiplicityCutsTheSurfaceApart) {
  Random random;
  for (int degree = 1; degree <= kMaxDegree; ++degree) {
    const Surface s(KnotVector::uniform(degree, 2), KnotVector::uniform(2, 0), 1,
                    random_numbers(random, 3 * (degree + 3)));
    const Surface cut = refine_u(s, std::vector<double>(static_cast<std::size_t>(degree) + 1, 0.5));
    EXPECT_EQ(cut.knots_u().multiplicity(0.5), degree + 1);
    EXPECT_LE(max_distance(s, cut), bound(s, degree));
    const Index at = cut.knots_u().find_span(0.5) - degree;  // both sides end in the point of the surface
    for (Index j = 0; j < 3; ++j) EXPECT_EQ(cut.control_point(at, j)[0], cut.control_point(at - 1, j)[0]);
  }
}

TEST(KnotRefinement, NamesWhatIsWrong) {
  const Surface s(KnotVector::clamped(2, std::vector<double>{0.5, 0.5}), KnotVector::uniform(1, 0), 1,
                  std::vector<double>(10, 1.0));
  const auto refuse_u = [&](std::vector<double> added, const std::string& words) {
    expect_throw<InvalidInput>([&] { refine_u(s, added); }, words);
  };
  refuse_u({0}, "knot 0 cannot be inserted: it is not inside the domain (0, 1)");
  refuse_u({1}, "knot 1 cannot be inserted");
  refuse_u({std::nan("")}, "knot nan cannot be inserted");
  refuse_u({0.5, 0.5},
           "knot 0.5 cannot be inserted: with 3 there already its multiplicity would pass degree + 1 = 3");
  refuse_u({0.3, 0.3, 0.3, 0.3}, "with 3 there already");
  refuse_u({0.7, 0.3}, "not sorted: 0.3 comes after 0.7");
  expect_throw<InvalidInput>([&] { insert_knot_v(s, 2); }, "knot 2 cannot be inserted");
  expect_throw<InvalidInput>([&] { insert_knot_u(Surface(), 0.5); }, "surface to refine is empty");
  expect_throw<InvalidInput>([&] { insert_knot_v(Surface(), 0.5); }, "surface to refine is empty");
}

}  // namespace
}  // namespace knotfit::test
