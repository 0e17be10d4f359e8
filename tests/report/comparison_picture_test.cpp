#include "knotfit/comparison_picture.h"

#include <gtest/gtest.h>

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

TEST(ErrorPlot, DrawsEveryFormatTheSameEachTime) {
  const std::vector<ErrorSeries> series{{"one", {{100, 1e-3}, {400, 1e-5}}},
                                        {"two", {{400, 2e-4}, {100, 3e-3}}}};
  for (const char* extension : {".svg", ".png", ".pdf"}) {
    const std::string a = draw_error_plot(series, "title", "RMS", extension);
    EXPECT_GT(a.size(), 500u);
    EXPECT_EQ(a, draw_error_plot(series, "title", "RMS", extension));
  }
  // The order of a series' points does not matter.
  const std::vector<ErrorSeries> sorted{series[0], {"two", {{100, 3e-3}, {400, 2e-4}}}};
  EXPECT_EQ(draw_error_plot(series, "t", "RMS", ".svg"), draw_error_plot(sorted, "t", "RMS", ".svg"));
}

TEST(ErrorPlot, TakesOnePointAndManySeries) {
  std::vector<ErrorSeries> series;
  for (int k = 0; k < 40; ++k) series.push_back({"series " + std::to_string(k), {{100, 1e-3 * (k + 1)}}});
  EXPECT_FALSE(draw_error_plot(series, "t", "RMS", ".svg").empty());
  EXPECT_FALSE(
      draw_error_plot({{"one", {{16, 1}}}}, "t", "RMS", ".svg", {.width = 200, .height = 200}).empty());
}

TEST(ErrorPlot, RefusesWhatHasNoLogarithm) {
  expect_throw<InvalidInput>(
      [] {
        draw_error_plot({{"a", {{100, 0}}}}, "t", "e", ".svg");
      },
      "a: 100 control points");
  expect_throw<InvalidInput>([] { draw_error_plot({{"a", {{-1, 1}}}}, "t", "e", ".svg"); }, "positive");
  expect_throw<InvalidInput>([] { draw_error_plot({{"a", {}}}, "t", "e", ".svg"); }, "at least one point");
  expect_throw<InvalidInput>([] { draw_error_plot({{"a", {{1, 1}}}}, "t", "e", ".gif"); }, ".gif");
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
