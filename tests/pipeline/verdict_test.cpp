#include "pipeline/verdict.h"

#include <gtest/gtest.h>

#include <string>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

Status verdict(Status searched, bool holds, bool swings = false, bool folded = false) {
  return status_of({searched, true, true, holds, swings, folded});
}

TEST(Verdict, HasOneOrderWhereSeveralApply) {
  EXPECT_EQ(verdict(Status::stopped, true, true, true), Status::stopped);
  EXPECT_EQ(verdict(Status::time_limit, true, true), Status::time_limit);
  EXPECT_EQ(verdict(Status::reached, true, true, true), Status::swings);
  EXPECT_EQ(verdict(Status::reached, true, false, true), Status::folded);
  EXPECT_EQ(verdict(Status::limit_reached, true), Status::reached);
  EXPECT_EQ(verdict(Status::limit_reached, false), Status::limit_reached);
  EXPECT_EQ(verdict(Status::data_too_sparse, false, true), Status::data_too_sparse);
  EXPECT_EQ(verdict(Status::reached, false), Status::not_reached) << "what the recheck does not confirm";
}

TEST(Verdict, OfAFixedSizeFollowsTheTolerance) {
  EXPECT_EQ(status_of({Status::fixed_size, false, false, false, true, true}), Status::fixed_size);
  EXPECT_EQ(status_of({Status::fixed_size, false, true, true, false, false}), Status::reached);
  EXPECT_EQ(status_of({Status::fixed_size, false, true, false, false, false}), Status::not_reached);
}

TEST(Judge, ReachedAsksBothTheErrorsAndTheSwings) {
  ParameterizedPoints points;
  points.uv = {0, 0, 0.5, 0.25, 1, 1};
  points.values = {1, 2, 3};
  FitResult r;
  r.errors = {0.1, 0.3, 0.2};
  r.tolerance = r.asked.value = 0.3;
  judge(r, points, Status::reached, true, true);
  EXPECT_EQ(r.measured, 0.3);
  EXPECT_EQ(r.error.worst, 1);
  EXPECT_TRUE(r.reached);
  EXPECT_EQ(r.status, Status::reached);
  r.swings.swings = true;
  judge(r, points, Status::reached, true, true);
  EXPECT_FALSE(r.reached);
  EXPECT_EQ(r.status, Status::swings);
  r.swings.swings = false;
  r.tolerance = r.asked.value = 0.29;
  judge(r, points, Status::reached, true, true);
  EXPECT_FALSE(r.reached);
  EXPECT_EQ(r.status, Status::not_reached);
}

TEST(NoteSwings, LeadsTheNotesAndSaysWhereInTheUsersParameters) {
  FitResult r;
  r.notes = {"another"};
  note_swings(r);
  EXPECT_EQ(r.notes.size(), 1u) << "nothing swings";
  r.swings.swings = true;
  r.swings.largest = 40;
  r.swings.distance = 0.5;
  r.swings.worst_u = 0.25;
  r.swings.worst_v = 0.75;
  note_swings(r);
  ASSERT_EQ(r.notes.size(), 2u);
  EXPECT_EQ(
      r.notes[0].find("the surface swings between the points: at u = 0.25, v = 0.75 it leaves the range of "
                      "the points about by 0.5, 40 times"),
      0u)
      << r.notes[0];
  EXPECT_EQ(r.notes[1], "another");
}

TEST(HeldNote, SaysWhetherTheSwingsAreOver) {
  EXPECT_NE(held_note(50, 1, "surface").find("(by 50 times the errors there)"), std::string::npos);
  EXPECT_NE(held_note(50, 1, "surface").find("holds the surface"), std::string::npos);
  EXPECT_NE(held_note(50, 49, "curve").find("lessens the swings of the curve"), std::string::npos);
}

}  // namespace
}  // namespace knotfit
