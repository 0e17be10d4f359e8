#include "fit/error_measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/random_splines.h"
namespace knotfit::test {
namespace {

TEST(ErrorMeasures, HaveARowEach) {
  std::set<std::string_view> names;
  for (const ErrorMeasure m : {ErrorMeasure::max, ErrorMeasure::rms, ErrorMeasure::percentile}) {
    EXPECT_EQ(row_of(m).measure, m);
    EXPECT_TRUE(names.insert(row_of(m).name).second);
  }
  EXPECT_EQ(names.size(), error_measures().size());
}

TEST(ErrorMeasures, AgreeFromTheSumsAndFromTheErrors) {
  Random random;
  std::vector<double> errors;
  double squares = 0, max = 0;
  for (int k = 0; k < 200; ++k) {
    errors.push_back(random.unit());
    squares += errors.back() * errors.back();
    max = std::max(max, errors.back());
  }
  for (const ErrorMeasureRow& row : error_measures()) {
    if (!row.of_sums) continue;
    EXPECT_NEAR(row.of_sums(std::sqrt(squares / 200), max), row.of_errors(errors, 1), 1e-15) << row.name;
  }
}

TEST(ErrorMeasures, AreWorded) {
  EXPECT_EQ(words_of({1, ErrorMeasure::max}), "largest error");
  EXPECT_EQ(words_of({1, ErrorMeasure::rms}), "RMS error");
  EXPECT_EQ(words_of({1, ErrorMeasure::percentile, 0.995}), "error of 99.5 % of the points");
}

}  // namespace
}  // namespace knotfit::test
