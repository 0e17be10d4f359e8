#include "solve/band_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random_splines.h"
namespace knotfit {
namespace {

using namespace knotfit::test;

/// A positive definite band matrix in lower band storage, its diagonal larger than the rest of a row.
std::vector<double> band_matrix(Random& random, Index rows, Index bandwidth) {
  std::vector<double> band(rows * (bandwidth + 1), 0.0);
  for (Index j = 0; j < rows; ++j)
    for (Index k = 0; k <= std::min(bandwidth, rows - 1 - j); ++k)
      band[j * (bandwidth + 1) + k] =
          k == 0 ? 2.0 * static_cast<double>(bandwidth) + 1 : random.uniform(-1, 1);
  return band;
}

/// Entry (i, j) of what lower band storage holds, 0 above the diagonal and below the band.
double entry(const std::vector<double>& band, Index bandwidth, Index i, Index j) {
  return i < j || i - j > bandwidth ? 0 : band[j * (bandwidth + 1) + i - j];
}

TEST(BandKernels, FactorTimesItsTransposeIsTheMatrix) {
  Random random;
  for (const auto& [rows, bandwidth] : {std::pair<Index, Index>{1, 3}, {9, 0}, {12, 3}, {40, 7}}) {
    const std::vector<double> matrix = band_matrix(random, rows, bandwidth);
    std::vector<double> l = matrix;
    ASSERT_TRUE(factor_narrow_band(l.data(), rows, bandwidth));
    for (Index i = 0; i < rows; ++i)
      for (Index j = std::max<Index>(0, i - bandwidth); j <= i; ++j) {
        double sum = 0;
        for (Index k = 0; k <= j; ++k) sum += entry(l, bandwidth, i, k) * entry(l, bandwidth, j, k);
        EXPECT_NEAR(sum, entry(matrix, bandwidth, i, j), 1e-13 * matrix[0]) << i << ", " << j;
      }
  }
}

TEST(BandKernels, APivotThatIsNotPositiveIsSaid) {
  std::vector<double> singular = {1, 1, 1, 0};  // [1 1; 1 1]
  EXPECT_FALSE(factor_narrow_band(singular.data(), 2, 1));
  std::vector<double> nan = {NAN, 0, 1, 0};
  EXPECT_FALSE(factor_narrow_band(nan.data(), 2, 1));
}

TEST(BandKernels, ForwardSolvesEightColumns) {
  Random random;
  constexpr Index rows = 23, bandwidth = 4;
  std::vector<double> l = band_matrix(random, rows, bandwidth);
  ASSERT_TRUE(factor_narrow_band(l.data(), rows, bandwidth));
  std::vector<double> right = random_numbers(random, rows * 8);
  std::fill(right.begin(), right.begin() + 3 * 8, 0.0);  // leading rows of zeros are passed over
  std::vector<double> x = right;
  forward_block(l.data(), rows, bandwidth, x.data());
  for (Index i = 0; i < rows; ++i)
    for (Index c = 0; c < 8; ++c) {
      double sum = 0;
      for (Index k = 0; k <= i; ++k) sum += entry(l, bandwidth, i, k) * x[k * 8 + c];
      EXPECT_NEAR(sum, right[i * 8 + c], 1e-13);
    }
}

TEST(BandKernels, ProductsAreThoseOfAPlainLoop) {
  Random random;
  constexpr Index rows = 17;
  const std::vector<double> x = random_numbers(random, rows * 8), y = random_numbers(random, rows * 8);
  std::vector<double> products(64, 1e300);  // written, not added to
  block_products(x.data(), y.data(), rows, products.data());
  for (Index i = 0; i < 8; ++i)
    for (Index j = 0; j < 8; ++j) {
      double sum = 0;
      for (Index row = 0; row < rows; ++row) sum += x[row * 8 + i] * y[row * 8 + j];
      EXPECT_NEAR(products[i * 8 + j], sum, 1e-14);
    }
}

}  // namespace
}  // namespace knotfit
