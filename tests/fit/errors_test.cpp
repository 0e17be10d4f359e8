// Summaries of errors: quantiles against a sort, messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
#include "knotfit/fit_least_squares.h"
#include "knotfit/tolerance.h"
#include "support/dense_reference.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

/// Least e of the list such that at least `share` of the list is <= e, by counting.
double by_counting(std::vector<double> errors, double share) {
  std::sort(errors.begin(), errors.end());
  for (double e : errors) {
    const auto within = std::count_if(errors.begin(), errors.end(), [&](double x) { return x <= e; });
    if (static_cast<long double>(within) >=
        static_cast<long double>(share) * static_cast<long double>(errors.size()) * (1 - 1e-12L))
      return e;
  }
  return errors.back();
}

TEST(ErrorQuantile, IsThatOfASort) {
  Random random;
  for (int n : {1, 2, 3, 10, 100, 200, 1000}) {
    std::vector<double> errors = random_numbers(random, n);
    for (double& e : errors) e = std::round(std::abs(e) * 50) / 50;  // ties
    for (double share : {1e-9, 0.005, 0.5, 0.95, 0.99, 0.995, 0.999, 1.0})
      EXPECT_EQ(error_quantile(errors, share), by_counting(errors, share)) << n << " errors, " << share;
    for (int k = 0; k < 20; ++k) {
      const double share = 1 - random.unit();
      EXPECT_EQ(error_quantile(errors, share), by_counting(errors, share)) << n << " errors, " << share;
    }
  }
}

TEST(ErrorQuantile, AsksForNoPointMoreThanTheShare) {
  // 0.07 * 100 is 7.000000000000001: 7 of 100 are enough.
  std::vector<double> errors;
  for (int k = 1; k <= 100; ++k) errors.push_back(k);
  EXPECT_EQ(error_quantile(errors, 0.07), 7);
  EXPECT_EQ(error_quantile(errors, 0.29), 29);
  EXPECT_EQ(error_quantile(errors, 0.291), 30);
}

TEST(ErrorQuantile, NeedsErrorsAndAShare) {
  for (double share : {0.0, -1.0, 1.1, std::numeric_limits<double>::quiet_NaN()})
    expect_throw<InvalidInput>([&] { error_quantile({1, 2}, share); }, "a share in (0, 1]");
  expect_throw<InvalidInput>([] { error_quantile({}, 0.5); }, "a quantile needs errors");
}

TEST(ErrorSummary, IsThatOfSlowSums) {
  Random random;
  for (int n : {1, 2, 7, 1000}) {
    const ParameterizedPoints points = random_points(random, n, 1);
    std::vector<double> errors = random_numbers(random, n);
    for (double& e : errors) e = std::abs(e);
    const ErrorSummary s = summarize_errors(errors, points);
    long double sum = 0, squares = 0;
    for (double e : errors) {
      sum += e;
      squares += static_cast<long double>(e) * e;
    }
    EXPECT_NEAR(s.mean, static_cast<double>(sum / n), n * kEps);
    EXPECT_NEAR(s.rms, static_cast<double>(std::sqrt(squares / n)), n * kEps);
    EXPECT_EQ(s.max, *std::max_element(errors.begin(), errors.end()));
    EXPECT_EQ(errors[s.worst], s.max);
    EXPECT_EQ(s.worst_u, points.u(s.worst));
    EXPECT_EQ(s.worst_v, points.v(s.worst));
    EXPECT_EQ(s.median, by_counting(errors, 0.5));
    EXPECT_EQ(s.p95, by_counting(errors, 0.95));
    EXPECT_EQ(s.p99, by_counting(errors, 0.99));
    EXPECT_EQ(s.p995, by_counting(errors, 0.995));
  }
}

TEST(ErrorSummary, OfPerfectFitNamesAPoint) {
  Random random;
  const ErrorSummary s = summarize_errors({0, 0}, random_points(random, 2, 1));
  EXPECT_EQ(s.max, 0);
  EXPECT_EQ(s.worst, 0);
}

TEST(ErrorSummary, NamesTheFirstBadError) {
  Random random;
  const ParameterizedPoints points = random_points(random, 3, 1);
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1.0})
    expect_throw<InvalidInput>([&] { summarize_errors({0, bad, bad}, points); }, "the error of point 1 is");
  expect_throw<InvalidInput>([&] { summarize_errors({}, points); }, "no errors to summarize");
  expect_throw<InvalidInput>([&] { summarize_errors({1, 2}, points); }, "2 errors for 3 points");
}

TEST(MeasuredError, IsTheOneAskedFor) {
  const std::vector<double> errors{3, 0, 4, 0};
  EXPECT_EQ(measured_error(errors, {1, ErrorMeasure::max}), 4);
  EXPECT_EQ(measured_error(errors, {1, ErrorMeasure::rms}), 2.5);
  EXPECT_EQ(measured_error(errors, {1, ErrorMeasure::percentile, 0.5}), 0);
  EXPECT_EQ(measured_error(errors, {1, ErrorMeasure::percentile, 0.75}), 3);
  for (ErrorMeasure measure : {ErrorMeasure::max, ErrorMeasure::rms, ErrorMeasure::percentile})
    expect_throw<InvalidInput>([&] { measured_error({}, {1, measure, 0.5}); }, "no errors to measure");
}

}  // namespace
}  // namespace knotfit::test
