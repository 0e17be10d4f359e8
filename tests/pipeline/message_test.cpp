#include "pipeline/message.h"

#include <gtest/gtest.h>

#include <string>

namespace knotfit {
namespace {

FitResult result(Status status) {
  FitResult r;
  r.status = status;
  const KnotVector u = KnotVector::uniform(3, 8), v = KnotVector::uniform(3, 5);
  r.surface = Surface(u, v, 1, std::vector<double>(static_cast<std::size_t>(u.size() * v.size()), 0.0));
  r.tolerance = r.asked.value = 0.02;
  r.measured = 0.01;
  r.noise = 0.5;
  return r;
}

TEST(Message, IsTheStatusWithItsFigures) {
  const std::string figures = "12 x 9 = 108 control points", errors = "0.01, tolerance 0.02";
  for (const auto& [status, words] :
       {std::pair{Status::reached, "hold the tolerance"},
        std::pair{Status::not_reached, "do not hold the tolerance"},
        std::pair{Status::data_too_sparse, "the 700 points are too sparse"},
        std::pair{Status::tolerance_below_noise, "standard deviation about 0.5"},
        std::pair{Status::swings, "between them the surface swings"},
        std::pair{Status::folded, "folds over the mesh"},
        std::pair{Status::limit_reached, "the limit on control points or fits was reached"},
        std::pair{Status::time_limit, "the time limit cut the search short; best 12"},
        std::pair{Status::stopped, "stopped; best 12"}, std::pair{Status::failed, "failed its own check"}}) {
    const std::string message = message_of(result(status), 700);
    for (const std::string& part : {std::string(words), figures, errors})
      EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  }
}

TEST(Message, WithoutAToleranceTellsTheErrors) {
  FitResult r = result(Status::fixed_size);
  r.tolerance = 0;
  r.error.rms = 0.25;
  r.error.max = 0.75;
  EXPECT_EQ(message_of(r, 9), "12 x 9 = 108 control points: RMS error 0.25, largest 0.75");
}

TEST(Message, OfASwingSaysWhetherAnySurfaceHolds) {
  FitResult r = result(Status::swings);
  r.measured = 0.03;
  EXPECT_NE(message_of(r, 9).find("every surface found that holds the tolerance at the points swings"),
            std::string::npos);
}

TEST(Message, OfOneThatHoldsSaysSoFar) {
  FitResult r = result(Status::stopped);
  r.reached = true;
  EXPECT_NE(message_of(r, 9).find("stopped; so far 12 x 9"), std::string::npos);
}

TEST(Message, TellsPointsThatWereLeftOut) {
  FitResult r = result(Status::reached);
  r.left_out = 3;
  r.all_max = 0.125;
  EXPECT_NE(message_of(r, 9).find("3 points of the input were merged or left out, and of all its points the "
                                  "farthest is 0.125 off"),
            std::string::npos);
}

TEST(Message, OfACurveNamesTheCurve) {
  CurveFitResult r;
  EXPECT_EQ(message_of(r, 9), "nothing was fitted");
  r.status = Status::reached;
  r.control_points = 7;
  r.tolerance = r.asked.value = 0.02;
  r.measured = 0.01;
  EXPECT_EQ(message_of(r, 9).find("7 control points hold the tolerance"), 0u);
  r.status = Status::failed;
  EXPECT_EQ(message_of(r, 9), "no curve: the normal equations of these knots cannot be solved");
}

}  // namespace
}  // namespace knotfit
