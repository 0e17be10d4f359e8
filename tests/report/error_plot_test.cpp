#include <gtest/gtest.h>

#include "knotfit/comparison_picture.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

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

}  // namespace
}  // namespace knotfit::test
