#include "search/better_of.h"

#include <gtest/gtest.h>
namespace knotfit {
namespace {

RefineResult result(int interior, double error, bool holds, bool swings = false) {
  RefineResult r;
  const KnotVector knots = KnotVector::uniform(3, interior);
  r.surface = Surface(knots, knots, 1,
                      std::vector<double>(static_cast<std::size_t>(knots.size() * knots.size()), 0.0));
  r.error = error;
  r.holds = holds;
  r.swings = swings;
  r.fits = 10;
  r.tried = {{interior + 4, interior + 4, error, holds}};
  r.status = holds ? Status::reached : Status::limit_reached;
  return r;
}

TEST(BetterOf, WhatHoldsBeatsWhatDoesNot) {
  EXPECT_EQ(better_of(result(9, 0.5, true), result(1, 1.5, false)).error, 0.5);
  EXPECT_EQ(better_of(result(1, 1.5, false), result(9, 0.5, true)).error, 0.5);
}

TEST(BetterOf, OfTwoThatHoldTheSmallerCounts) {
  EXPECT_EQ(better_of(result(4, 0.2, true), result(3, 0.9, true)).error, 0.9);
  EXPECT_EQ(better_of(result(3, 0.2, true), result(3, 0.1, true)).error, 0.2) << "the first of equals";
}

TEST(BetterOf, OfTwoThatDoNotTheOneThatDoesNotSwing) {
  EXPECT_EQ(better_of(result(4, 1.2, false, true), result(4, 3, false)).error, 3);
  EXPECT_EQ(better_of(result(4, 2, false), result(4, 1.5, false)).error, 1.5);
}

TEST(BetterOf, ASurfaceBeatsNone) {
  RefineResult none;
  none.fits = 3;
  const RefineResult best = better_of(none, result(2, 9, false));
  EXPECT_EQ(best.error, 9);
  EXPECT_EQ(best.fits, 13);
}

TEST(BetterOf, FitsAndSizesAreThoseOfBoth) {
  const RefineResult best = better_of(result(4, 0.2, true), result(3, 0.9, true));
  EXPECT_EQ(best.fits, 20);
  ASSERT_EQ(best.tried.size(), 2u);
}

TEST(BetterOf, AStopOfEitherStays) {
  for (const bool first : {true, false}) {
    RefineResult a = result(4, 0.2, true), b = result(3, 0.1, true);
    (first ? a : b).status = Status::stopped;
    EXPECT_EQ(better_of(a, b).status, Status::stopped);
  }
}

TEST(BetterOf, ATimeLimitOfTheFirstStaysThatOfAFurtherOneOnlyWhereNeitherHolds) {
  RefineResult cut = result(5, 0.1, true), reached = result(4, 0.2, true), missed = result(4, 2, false);
  cut.status = Status::time_limit;
  EXPECT_EQ(better_of(cut, reached).status, Status::time_limit);
  EXPECT_EQ(better_of(reached, cut).status, Status::reached);
  RefineResult worse = result(5, 5, false);
  worse.status = Status::time_limit;
  EXPECT_EQ(better_of(missed, worse).status, Status::time_limit);
}

TEST(After, ShowsTheEarlierUntilTheLaterIsBetter) {
  const RefineResult earlier = result(4, 2, false);
  Progress told;
  Control control;
  control.progress = [&](const Progress& p) { told = p; };
  const Control later = after(earlier, control);
  Progress p;
  p.error = 3;
  later.progress(p);
  EXPECT_EQ(told.error, 2);
  EXPECT_EQ(told.size_u, 8);
  p.error = 1.5;
  p.size_u = 20;
  later.progress(p);
  EXPECT_EQ(told.error, 1.5);
  EXPECT_EQ(told.size_u, 20);
}

}  // namespace
}  // namespace knotfit
