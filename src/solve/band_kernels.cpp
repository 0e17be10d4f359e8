#include "solve/band_kernels.h"

#include <algorithm>
#include <cmath>

#include "base/clones.h"
namespace knotfit {
namespace {

constexpr int kColumns = 8;  // of right-hand sides, taken side by side in vector registers

// Clones are local: a shared library would export the choosers of others.

KNOTFIT_CLONES bool factor_narrow_band_clones(double* band, Index rows, Index bandwidth) {
  for (Index j = 0; j < rows; ++j) {
    double* __restrict column = band + j * (bandwidth + 1);
    if (!(column[0] > 0)) return false;
    column[0] = std::sqrt(column[0]);
    const Index below = std::min(bandwidth, rows - 1 - j);
    for (Index k = 1; k <= below; ++k) column[k] /= column[0];
    for (Index k = 1; k <= below; ++k) {
      const double factor = column[k];
      double* __restrict other = band + (j + k) * (bandwidth + 1);
      for (Index i = 0; i <= below - k; ++i) other[i] -= column[k + i] * factor;
    }
  }
  return true;
}

KNOTFIT_CLONES void forward_block_clones(const double* factor, Index rows, Index bandwidth, double* x) {
  Index first = 0;
  for (; first < rows; ++first) {  // rows of zeros stay zero
    bool zero = true;
    for (int c = 0; c < kColumns; ++c) zero = zero && x[first * kColumns + c] == 0;
    if (!zero) break;
  }
  for (Index j = first; j < rows; ++j) {
    const double* column = factor + j * (bandwidth + 1);
    double solved[kColumns];
    for (int c = 0; c < kColumns; ++c) x[j * kColumns + c] = solved[c] = x[j * kColumns + c] / column[0];
    const Index below = std::min(bandwidth, rows - 1 - j);
    for (Index k = 1; k <= below; ++k)
      for (int c = 0; c < kColumns; ++c) x[(j + k) * kColumns + c] -= column[k] * solved[c];
  }
}

KNOTFIT_CLONES void block_products_clones(const double* x, const double* y, Index rows, double* products) {
  double sum[kColumns][kColumns] = {};
  for (Index row = 0; row < rows; ++row)
    for (int i = 0; i < kColumns; ++i)
      for (int j = 0; j < kColumns; ++j) sum[i][j] += x[row * kColumns + i] * y[row * kColumns + j];
  for (int i = 0; i < kColumns; ++i)
    for (int j = 0; j < kColumns; ++j) products[i * kColumns + j] = sum[i][j];
}

}  // namespace

bool factor_narrow_band(double* band, Index rows, Index bandwidth) {
  return factor_narrow_band_clones(band, rows, bandwidth);
}

void forward_block(const double* factor, Index rows, Index bandwidth, double* x) {
  forward_block_clones(factor, rows, bandwidth, x);
}

void block_products(const double* x, const double* y, Index rows, double* products) {
  block_products_clones(x, y, rows, products);
}

}  // namespace knotfit
