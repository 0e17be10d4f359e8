#include <gtest/gtest.h>

#include "knotfit/comparison_picture.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

Surface flat(int interior) {
  const KnotVector knots = KnotVector::uniform(3, interior);
  return Surface(knots, knots, 1,
                 std::vector<double>(static_cast<std::size_t>(knots.size() * knots.size()), 0.5));
}

TEST(ErrorMaps, DrawsPanelsInOneScale) {
  const ParameterizedPoints points = synthetic_points("franke", 500);
  const Surface a = flat(2), b = flat(7);
  const std::vector<double> errors(500, 0.25);
  const std::vector<ComparedSurface> both{{"a", "RMS 1", &a, errors}, {"b", "", &b, errors}};
  const std::string svg = draw_error_maps(both, points, 1, "title", ".svg");
  EXPECT_EQ(svg, draw_error_maps(both, points, 1, "title", ".svg"));
  EXPECT_NE(svg, draw_error_maps(both, points, 2, "title", ".svg")) << "another scale, other colours";
  std::vector<ComparedSurface> many(30, both[0]);
  EXPECT_FALSE(draw_error_maps(many, points, 1, "title", ".png").empty());
}

TEST(ErrorMaps, RangeIsAQuantileOfAllErrors) {
  const Surface s = flat(0);
  std::vector<double> errors(1000, 1.0);
  errors[5] = 1e6;
  EXPECT_EQ(error_range({{"a", "", &s, errors}}), 1.0);
  EXPECT_EQ(error_range({{"a", "", &s, std::vector<double>(10, 0.0)}}), 1.0);
  std::vector<double> nearly(1000, 0.0);
  nearly[7] = 3;
  EXPECT_EQ(error_range({{"a", "", &s, nearly}}), 3.0);
}

TEST(ErrorMaps, RefusesWhatItCannotDraw) {
  const ParameterizedPoints points = synthetic_points("franke", 50);
  const Surface s = flat(1);
  const Surface none;
  const std::vector<double> errors(50, 1.0);
  expect_throw<InvalidInput>([&] { draw_error_maps({}, points, 1, "t", ".svg"); }, "at least one surface");
  expect_throw<InvalidInput>(
      [&] {
        draw_error_maps({{"a", "", &none, errors}}, points, 1, "t", ".svg");
      },
      "a: there is no surface");
  expect_throw<InvalidInput>(
      [&] {
        draw_error_maps({{"a", "", &s, {1, 2}}}, points, 1, "t", ".svg");
      },
      "2 errors for 50 points");
  std::vector<double> bad = errors;
  bad[3] = NAN;
  expect_throw<InvalidInput>(
      [&] {
        draw_error_maps({{"a", "", &s, bad}}, points, 1, "t", ".svg");
      },
      "not finite");
  expect_throw<InvalidInput>(
      [&] {
        draw_error_maps({{"a", "", &s, errors}}, points, 0, "t", ".svg");
      },
      "a colour scale up to 0");
}

}  // namespace
}  // namespace knotfit::test
