// What a search refuses.
#include <gtest/gtest.h>

#include <limits>

#include "knotfit/exceptions.h"
#include "search/searches.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

class Refused : public testing::TestWithParam<RefineRoute> {
 protected:
  ParameterizedPoints points_ = synthetic_points("franke", 300);
  void expect(const RefineOptions& options, const std::string& words) const {
    RefineOptions o = options;
    o.route = GetParam();
    expect_throw<InvalidInput>([&] { refine_to_tolerance(points_, o); }, words);
  }
};

TEST_P(Refused, TolerancesThatAreNotPositive) {
  for (double bad :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    expect(to_max_error(bad), "it must be positive and finite");
  expect(to_max_error(-2), "the tolerance is -2");
}

TEST_P(Refused, TolerancesBelowTheRoundingOfTheData) {
  expect(to_max_error(1e-17), "is below the rounding of values as large as 1.");
}

TEST_P(Refused, PercentilesOutsideTheirRange) {
  for (double share : {0.0, -0.5, 1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
    RefineOptions options = to_max_error(1e-2);
    options.tolerance.measure = ErrorMeasure::percentile;
    options.tolerance.share = share;
    expect(options, "it must lie between 0 and 100 %");
  }
}

TEST_P(Refused, LimitsBelowOnePatch) {
  RefineOptions options = to_max_error(1e-2);
  options.max_control_points = 15;
  expect(options, "at most 15 control points are fewer than the 16 of one patch of degree 3x3");
  options.max_control_points = -1;
  expect(options, "at most -1 control points");
  options = to_max_error(1e-2);
  options.span_ratio = -1;
  expect(options, "a ratio of spans of -1: it must be positive");
  options.span_ratio = INFINITY;
  expect(options, "a ratio of spans of inf");
  options.span_ratio = 0;
  options.max_fits = -1;
  expect(options, "the number of fits allowed is negative");
}

TEST_P(Refused, UnknownMethodsDegreesAndPoints) {
  expect(to_max_error(1e-2, "no-such"), "there is no placement method 'no-such'");
  RefineOptions options = to_max_error(1e-2);
  options.degree_u = 12;
  expect(options, "degree 12 is outside [1, 9]");
  points_.uv[6] = -1;
  expect(to_max_error(1e-2), "point 3 has parameters (-1,");
}

TEST_P(Refused, FeatureMapsThatAreNone) {
  RefineOptions options = to_max_error(1e-2);
  options.user_features = FeatureMap{1, 2, {1, -1}};
  expect(options, "the feature measure of cell (0, 1) is -1");
}

INSTANTIATE_TEST_SUITE_P(Routes, Refused, testing::Values(RefineRoute::search, RefineRoute::insert),
                         [](const auto& at) {
                           return at.param == RefineRoute::search ? "search" : "insert";
                         });

}  // namespace
}  // namespace knotfit::test
