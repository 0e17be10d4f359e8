#include "knotfit/compare.h"

#include <gtest/gtest.h>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(Compare, RunsSizesThenTolerancesByEveryMethod) {
  CompareOptions options;
  options.methods = {"uniform", "criterion:residual", "uniform"};
  options.sizes = {{5, 6}, {8, 8}};
  options.tolerances = {{.value = 10, .relative = true}};
  options.fit.between = false;
  std::vector<std::string> heard;
  const ParameterizedPoints points = synthetic_points("franke", 600);
  const std::vector<CompareRow> rows =
      compare_methods(points, options, {}, [&](const CompareRow& row) { heard.push_back(row.method); });
  ASSERT_EQ(rows.size(), 6u);  // a method named twice is run once
  EXPECT_EQ(heard, (std::vector<std::string>{"uniform", "criterion:residual", "uniform", "criterion:residual",
                                             "uniform", "criterion:residual"}));
  EXPECT_EQ(rows[0].result.surface.size_u(), 5);
  EXPECT_EQ(rows[0].result.surface.size_v(), 6);
  EXPECT_EQ(rows[3].result.surface.size_v(), 8);
  EXPECT_TRUE(rows[4].result.reached);
  for (const CompareRow& row : rows) {
    EXPECT_TRUE(row.fitted);
    EXPECT_GE(row.seconds, 0);
  }
  // A row is the fit itself.
  FitOptions fit;
  fit.method = "criterion";
  fit.feature = FeatureMeasure::residual;
  fit.control_points_u = fit.control_points_v = 8;
  fit.between = false;
  EXPECT_EQ(rows[3].result.surface, fit_surface(points, fit).surface);
}

TEST(Compare, AllIsEveryMethodAndTheCriterionOnEveryMeasure) {
  CompareOptions options;
  options.sizes = {{5, 5}};
  const std::vector<CompareRow> rows = comparison_rows(options);
  EXPECT_EQ(rows.size(), placement_methods().size() + 3);
}

TEST(Compare, AMethodThatFailsIsARow) {
  CompareOptions options;
  options.methods = {"uniform"};
  options.sizes = {{20, 20}, {4, 4}};
  options.fit.between = false;
  const std::vector<CompareRow> rows = compare_methods(synthetic_points("franke", 100), options);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_FALSE(rows[0].fitted);
  EXPECT_NE(rows[0].failure.find("100 points are fewer than 20 x 20"), std::string::npos);
  EXPECT_TRUE(rows[1].fitted);
}

TEST(Compare, AStopKeepsTheRowsThatEnded) {
  CompareOptions options;
  options.methods = {"uniform", "quantile"};
  options.sizes = {{5, 5}, {6, 6}};
  options.fit.between = false;
  std::stop_source source;
  Control control;
  control.stop = source.get_token();
  int count = 0;
  const std::vector<CompareRow> rows =
      compare_methods(synthetic_points("franke", 300), options, control, [&](const CompareRow&) {
        if (++count == 3) source.request_stop();
      });
  EXPECT_EQ(rows.size(), 3u);
}

TEST(Compare, RefusesWhatIsNotThere) {
  CompareOptions options;
  expect_throw<InvalidInput>([&] { comparison_rows(options); }, "sizes or tolerances");
  options.sizes = {{5, 5}};
  options.methods = {"best"};
  expect_throw<InvalidInput>([&] { comparison_rows(options); },
                             "no placement method 'best'; there are optimal");
  options.methods = {"criterion:colour"};
  expect_throw<InvalidInput>([&] { comparison_rows(options); }, "no feature measure 'colour'");
  options.methods = {};
  expect_throw<InvalidInput>([&] { comparison_rows(options); }, "needs methods");
  options.methods = {"all"};
  options.sizes = {{5, 5}, {6, 5}};
  options.fit.degree_v = 5;
  expect_throw<InvalidInput>([&] { comparison_rows(options); },
                             "5 x 5 control points: degree 3x5 needs at least 4 x 6");
}

}  // namespace
}  // namespace knotfit::test
