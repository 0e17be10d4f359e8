#include "parameterize/row_parameters.h"

#include <gtest/gtest.h>

#include <limits>

#include "knotfit/parameterize.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

using test::expect_throw;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr RowSpacing kAll[] = {RowSpacing::chord, RowSpacing::centripetal, RowSpacing::uniform};

TEST(AveragedParameters, FillWhatALineDoesNotKnow) {
  // Two lines of scales 1 and 10, each blind in one gap.
  const std::vector<double> lengths = {1, kNan, 3, 10, 20, kNan};
  const std::vector<double> t = parameterize::averaged_parameters(lengths, 3);
  EXPECT_NEAR(t[1], 1.0 / 6, 1e-12);
  EXPECT_NEAR(t[2], 0.5, 1e-12);
  EXPECT_EQ(t[3], 1);
}

}  // namespace
}  // namespace knotfit
