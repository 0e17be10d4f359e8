#include "report/error_field.h"

#include <gtest/gtest.h>

#include "scenes.h"
namespace knotfit::report {
namespace {

TEST(ErrorField, GivesEachPointsErrorAtThePoint) {
  // Far enough apart for a cell each and cells of the same value all around.
  ParameterizedPoints points;
  std::vector<double> errors;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      points.uv.insert(points.uv.end(), {(i + 0.5) / 20, (j + 0.5) / 20});
      points.values.push_back(0);
      errors.push_back((i * 7 + j * 3) % 11 - 5.0);
    }
  const ErrorField field(points, errors, {});
  for (Index k = 0; k < points.size(); ++k) {
    const auto e = field.at(points.u(k), points.v(k));
    ASSERT_TRUE(e);
    EXPECT_NEAR(*e, errors[k], 1e-12);
  }
}

TEST(ErrorField, KeepsTheWorstOfPointsThatShareACell) {
  ParameterizedPoints points;
  points.uv = {0.5, 0.5, 0.5001, 0.5001, 0.5002, 0.5};
  points.values = {0, 0, 0};
  EXPECT_EQ(*ErrorField(points, {1, -3, 2}, {}).at(0.5, 0.5), -3);
}

TEST(ErrorField, SaysNothingFarFromData) {
  ParameterizedPoints points = scenes::random_points(4000);
  ParameterizedPoints left;
  for (Index k = 0; k < points.size(); ++k)
    if (points.u(k) < 0.5) {
      left.uv.insert(left.uv.end(), {points.u(k), points.v(k)});
      left.values.push_back(0);
    }
  const ErrorField field(left, std::vector<double>(left.values.size(), 1.0), {});
  for (double v = 0; v <= 1; v += 0.02) {
    EXPECT_FALSE(field.at(0.75, v)) << v;
    ASSERT_TRUE(field.at(0.25, v)) << v;
    EXPECT_EQ(*field.at(0.25, v), 1);
  }
}

TEST(ErrorField, FollowsTheDomainOfTheSurface) {
  ParameterizedPoints points;
  points.uv = {2.1, 10.0, 3.9, 30.0};
  points.values = {0, 0};
  const ErrorField field(points, {1, -1}, {2, 4, 10, 30});
  EXPECT_EQ(*field.at(2.05, 10.2), 1);
  EXPECT_EQ(*field.at(3.95, 29.8), -1);
}

TEST(ThinField, IsThinAboutThePlacesOnly) {
  const ThinField field({{.u = 0.3, .v = 0.6}}, {});
  EXPECT_LT(field.ratio(0.3, 0.6), 0.3);
  EXPECT_LT(field.ratio(0.31, 0.6), 1);
  EXPECT_GT(field.ratio(0.34, 0.6), 1);
  EXPECT_GT(field.ratio(0.6, 0.3), 1);
  EXPECT_TRUE(ThinField({}, {}).empty());
  EXPECT_GT(ThinField({}, {}).ratio(0.5, 0.5), 1);
}

TEST(ThinField, IsOutlinedAtItsRadius) {
  const ThinField field({{.u = 0.3, .v = 0.6}}, {});
  const std::vector<Vec2> outline = field.outline();
  ASSERT_GT(outline.size(), 16u);
  for (const Vec2& p : outline) EXPECT_NEAR(std::hypot(p.x - 0.3, p.y - 0.6), 0.026, 0.002);
}

TEST(ThinField, TakesPlacesOnTheBorder) {
  const ThinField field({{.u = 0, .v = 0}, {.u = 1, .v = 1}}, {});
  EXPECT_LT(field.ratio(0, 0), 1);
  EXPECT_LT(field.ratio(1, 1), 1);
}

TEST(OpeningField, IsInsideItsTrianglesEitherWayRound) {
  for (const bool turned : {false, true}) {
    std::array<double, 6> t{10, 1, 20, 1, 20, 3};
    if (turned) t = {10, 1, 20, 3, 20, 1};
    const OpeningField field({t}, {0, 40, 0, 4});
    EXPECT_TRUE(field.inside(18, 1.5));
    EXPECT_TRUE(field.inside(19.9, 2.9));
    EXPECT_FALSE(field.inside(12, 2));
    EXPECT_FALSE(field.inside(20.2, 2));
    EXPECT_FALSE(field.inside(15, 0.98));
  }
  EXPECT_TRUE(OpeningField({}, {}).empty());
  EXPECT_FALSE(OpeningField({}, {}).inside(0.5, 0.5));
}

}  // namespace
}  // namespace knotfit::report
