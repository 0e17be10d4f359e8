#include <gtest/gtest.h>

#include <limits>

#include "knotfit/exceptions.h"
#include "knotfit/surface.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
#include "support/sampling.h"
namespace knotfit::test {
namespace {

const double kAnything = std::numeric_limits<double>::infinity();

double any_of(Random& random, const std::vector<double>& values) {
  return values[static_cast<std::size_t>(random.integer(0, static_cast<int>(values.size()) - 1))];
}

double new_knot(Random& random, const KnotVector& t) {
  return t.first() + (t.last() - t.first()) * (0.01 + 0.98 * random.unit());
}

TEST(KnotRemoval, AfterInsertionRestoresTheSurface) {
  Random random;
  for (const Surface& s : random_surfaces(seed(), 200)) {
    const double knot = new_knot(random, s.knots_u());
    const Surface more = insert_knot_u(s, knot);
    const KnotRemoval back = remove_knot_u(more, knot, kAnything);
    ASSERT_TRUE(back.removed);
    EXPECT_EQ(back.surface.knots_u(), s.knots_u());
    // In eps scale: the insertion rounds each point by 4, so y . c by at most 12 (sum |y| <= 3);
    // the solve leaves 4 a row, degree + 2 rows; 8 are added for the rounding of that check.
    EXPECT_LE(back.error, (12 + 4 * (s.degree_u() + 2) + 8) * std::sqrt(s.dimension()) * kEps * s.scale());
    EXPECT_LE(max_distance(s, back.surface),
              back.error +
                  std::sqrt(s.dimension()) * 2 * (evaluation_error(s) + 4 * s.degree_u() * kEps * s.scale()));
    const double knot_v = new_knot(random, s.knots_v());
    const KnotRemoval back_v = remove_knot_v(insert_knot_v(s, knot_v), knot_v, 1e-9 * s.scale());
    ASSERT_TRUE(back_v.removed);
    EXPECT_EQ(back_v.surface.knots_v(), s.knots_v());
  }
}

TEST(KnotRemoval, MovesTheSurfaceByNoMoreThanItsBound) {
  Random random;
  int removals = 0;
  for (const Surface& s : random_surfaces(seed() + 1, 400)) {
    const double rounding = 2 * std::sqrt(s.dimension()) * evaluation_error(s);
    if (!s.knots_u().interior().empty()) {
      const KnotRemoval r = remove_knot_u(s, any_of(random, s.knots_u().interior()), kAnything);
      ASSERT_TRUE(r.removed);
      const double moved = max_distance(s, r.surface, 8);
      EXPECT_LE(
          moved,
          r.error + rounding +
              (r.surface.scale() > s.scale() ? std::sqrt(s.dimension()) * evaluation_error(r.surface) : 0));
      ++removals;
    }
    if (!s.knots_v().interior().empty()) {
      const KnotRemoval r = remove_knot_v(s, any_of(random, s.knots_v().interior()), kAnything);
      ASSERT_TRUE(r.removed);
      EXPECT_LE(
          max_distance(s, r.surface, 8),
          r.error + rounding +
              (r.surface.scale() > s.scale() ? std::sqrt(s.dimension()) * evaluation_error(r.surface) : 0));
      ++removals;
    }
  }
  EXPECT_GT(removals, 300);
}

// A polygon with 8 times the knots is near its spline, so the bound is near the move.
TEST(KnotRemoval, HasABoundNearTheMove) {
  Random random;
  for (int k = 0; k < 100; ++k) {
    const int p = random.integer(1, 5), q = random.integer(1, 5), dimension = random.integer(1, 3);
    const KnotVector u = KnotVector::uniform(p, 6), v = KnotVector::uniform(q, 6);
    const Surface s(u, v, dimension, random_numbers(random, u.size() * v.size() * dimension));
    const KnotRemoval r = remove_knot_u(s, any_of(random, u.interior()), kAnything);
    EXPECT_LE(r.error, 1.25 * max_distance(s, r.surface, 15)) << p << " " << q;
  }
}

// Least possible max move of the control points when the end rows stay: a cubic with simple
// uniform knots has y = (1,-4,6,-4,1), so the moved points go by |y . c| / 14.
TEST(KnotRemoval, SpreadsTheMoveOverThePointsItTouches) {
  const KnotVector u(3, {0, 1, 2, 3, 4, 5, 6, 7, 8}), v = KnotVector::uniform(1, 0);
  std::vector<double> net(10, 0.0);
  net[4] = net[5] = 14;  // the middle of five control points
  const Surface s(u, v, 1, net);
  const KnotRemoval r = remove_knot_u(s, 4, kAnything);
  const Surface back = insert_knot_u(r.surface, 4);
  const std::vector<double> moves = {0, -6, 6, -6, 0};
  for (Index i = 0; i < 5; ++i)
    EXPECT_NEAR(s.control_point(i, 0)[0] - back.control_point(i, 0)[0], moves[i], 1e-13);
}

TEST(KnotRemoval, LeavesTheSurfaceWhereTheErrorPassesTheTolerance) {
  Random random;
  const KnotVector u = KnotVector::uniform(3, 5), v = KnotVector::uniform(2, 4);
  const Surface s(u, v, 3, random_numbers(random, u.size() * v.size() * 3));
  for (double knot : u.interior()) {
    const double error = remove_knot_u(s, knot, kAnything).error;
    const KnotRemoval kept = remove_knot_u(s, knot, error * 0.999), gone = remove_knot_u(s, knot, error);
    EXPECT_FALSE(kept.removed);
    EXPECT_EQ(kept.surface, s);
    EXPECT_EQ(kept.error, error);
    EXPECT_TRUE(gone.removed);
    EXPECT_EQ(gone.surface.size_u(), s.size_u() - 1);
  }
  const KnotRemoval in_v = remove_knot_v(s, v.interior()[1], 0);
  EXPECT_FALSE(in_v.removed);
  EXPECT_EQ(in_v.surface, s);
}

TEST(KnotRemoval, KeepsAClampedBoundary) {
  Random random;
  const KnotVector u = KnotVector::uniform(3, 1), v = KnotVector::uniform(3, 1);
  const Surface s(u, v, 1, random_numbers(random, u.size() * v.size()));
  const Surface less = remove_knot_u(s, 0.5, kAnything).surface;
  for (Index j = 0; j < s.size_v(); ++j) {
    EXPECT_EQ(less.control_point(0, j)[0], s.control_point(0, j)[0]);
    EXPECT_EQ(less.control_point(less.size_u() - 1, j)[0], s.control_point(s.size_u() - 1, j)[0]);
  }
}

TEST(KnotRemoval, ClosesAJumpHalfway) {
  const KnotVector u = KnotVector::clamped(1, std::vector<double>{0.5, 0.5}), v = KnotVector::uniform(1, 0);
  const Surface s(u, v, 1, {0, 0, 1, 1, 3, 3, 0, 0});
  const KnotRemoval r = remove_knot_u(s, 0.5, kAnything);
  EXPECT_EQ(r.surface.net(), (std::vector<double>{0, 0, 2, 2, 0, 0}));
  EXPECT_NEAR(r.error, 1, 50 * kEps);
}

TEST(KnotRemoval, NamesWhatIsWrong) {
  const Surface s(KnotVector::uniform(2, 1), KnotVector::uniform(2, 0), 1, std::vector<double>(12, 1.0));
  expect_throw<InvalidInput>([&] { remove_knot_u(s, 0.4, 1); }, "0.4 is not an interior knot");
  expect_throw<InvalidInput>([&] { remove_knot_u(s, 0, 1); }, "0 is not an interior knot");
  expect_throw<InvalidInput>([&] { remove_knot_v(s, 0.5, 1); }, "0.5 is not an interior knot");
  expect_throw<InvalidInput>([&] { remove_knot_u(s, 0.5, -1); }, "tolerance is -1; it must be >= 0");
  expect_throw<InvalidInput>([&] { remove_knot_v(s, 0.5, std::nan("")); }, "tolerance is nan");
  expect_throw<InvalidInput>([&] { remove_knot_u(s, std::nan(""), 1); }, "is NaN");
  expect_throw<InvalidInput>([&] { remove_knot_u(Surface(), 0.5, 1); },
                             "surface to remove a knot from is empty");
  expect_throw<InvalidInput>([&] { remove_knot_v(Surface(), 0.5, 1); },
                             "surface to remove a knot from is empty");
}

}  // namespace
}  // namespace knotfit::test
