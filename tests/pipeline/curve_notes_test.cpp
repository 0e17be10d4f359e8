#include "pipeline/curve_notes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace knotfit {
namespace {

/// A straight curve of length 1, fitted to points at these parameters.
std::vector<std::string> notes(std::vector<double> t, bool function = false) {
  CurveFitResult fit;
  CurvePoints points;
  fit.curve = Curve(KnotVector::uniform(1, 0), 2, {0, 0, 1, 0});
  points.function = function;
  for (const double x : t) points.values.insert(points.values.end(), {x, 0});
  points.t = fit.t = std::move(t);
  return curve_notes(fit, points);
}

std::vector<double> even(double begin, double end, int count) {
  std::vector<double> t;
  for (int k = 0; k < count; ++k) t.push_back(begin + (end - begin) * k / (count - 1));
  return t;
}

TEST(CurveNotes, APartWithoutDataIsTold) {
  std::vector<double> t = even(0, 0.25, 30);
  for (const double x : even(0.5, 1, 60)) t.push_back(x);
  const auto said = notes(t);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].find("25 % of the curve's length, from t = 0.25 to t = 0.5, hold no data"), 0u)
      << said[0];
  EXPECT_TRUE(notes(t, true).empty()) << "a function has its own";
}

TEST(CurveNotes, EvenPointsAndFewSayNothing) {
  EXPECT_TRUE(notes(even(0, 1, 50)).empty());
  EXPECT_TRUE(notes(even(0, 1, 5)).empty()) << "steps as long as all others are no gap";
}

TEST(CurveNotes, EndsThatAreOnePointAreTold) {
  CurveFitResult fit;
  CurvePoints points;
  fit.curve = Curve(KnotVector::uniform(1, 1), 2, {0, 0, 1, 0, 0, 0});
  points.t = fit.t = even(0, 1, 9);
  for (const double t : fit.t) points.values.insert(points.values.end(), {1 - std::abs(2 * t - 1), 0});
  const auto said = curve_notes(fit, points);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].find("the first and the last point are equal"), 0u);
  points.closed = true;
  EXPECT_TRUE(curve_notes(fit, points).empty());
}

TEST(CurveNotes, ASwingLeads) {
  CurveFitResult fit;
  CurvePoints points;
  points.function = true;
  points.dimension = 1;
  points.x0 = 10;
  points.x1 = 30;
  fit.swings.swings = true;
  fit.swings.largest = 40;
  fit.swings.distance = 2;
  fit.swings.worst_u = 0.5;
  const auto said = curve_notes(fit, points);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].find("the curve swings between the points: at x = 20 it leaves"), 0u) << said[0];
}

}  // namespace
}  // namespace knotfit
