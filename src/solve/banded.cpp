#include "solve/banded.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/narrow.h"
#include "base/parallel.h"
#include "solve/band_kernels.h"

extern "C" {
void dpbtrf_(const char* uplo, const int* n, const int* kd, double* ab, const int* ldab, int* info);
void dpbtrs_(const char* uplo, const int* n, const int* kd, const int* nrhs, const double* ab,
             const int* ldab, double* b, const int* ldb, int* info);
void dpbcon_(const char* uplo, const int* n, const int* kd, const double* ab, const int* ldab,
             const double* anorm, double* rcond, double* work, int* iwork, int* info);
// Where the LAPACK is OpenBLAS: its own threads change the bits and, on a busy machine, are
// 20 times slower than one.
void openblas_set_num_threads(int) __attribute__((weak));
}

namespace knotfit {
namespace {

constexpr Index kNarrow = 64;  // LAPACK's blocks start beyond

void one_blas_thread() {
  static const bool done = [] {
    if (openblas_set_num_threads) openblas_set_num_threads(1);
    return true;
  }();
  static_cast<void>(done);
}

}  // namespace

void BandMatrix::reset(Index size, Index bandwidth) {
  size_ = size;
  bandwidth_ = std::min(bandwidth, size - 1);
  narrow(size_);
  data_.assign(static_cast<std::size_t>(size_ * (bandwidth_ + 1)), 0.0);
}

std::vector<double> BandMatrix::times(const std::vector<double>& x) const {
  std::vector<double> y(x.size(), 0.0);
  for (std::size_t begin = 0; begin < x.size(); begin += static_cast<std::size_t>(size_))
    for (Index j = 0; j < size_; ++j) {
      const double* a = column(j);
      const double* from = x.data() + begin;
      double* to = y.data() + begin;
      to[j] += a[0] * from[j];
      for (Index k = 1; k <= std::min(bandwidth_, size_ - 1 - j); ++k) {
        to[j + k] += a[k] * from[j];
        to[j] += a[k] * from[j + k];
      }
    }
  return y;
}

double BandMatrix::trace() const {
  double sum = 0;
  for (Index j = 0; j < size_; ++j) sum += data_[j * (bandwidth_ + 1)];
  return sum;
}

double BandMatrix::norm_1() const {
  std::vector<double> sum(static_cast<std::size_t>(size_), 0.0);
  for (Index j = 0; j < size_; ++j) {
    const double* a = data_.data() + j * (bandwidth_ + 1);
    sum[j] += std::abs(a[0]);
    for (Index k = 1; k <= std::min(bandwidth_, size_ - 1 - j); ++k) {
      sum[j] += std::abs(a[k]);
      sum[j + k] += std::abs(a[k]);
    }
  }
  return *std::max_element(sum.begin(), sum.end());
}

bool BandMatrix::factor(double least_pivot) {
  one_blas_thread();
  const int n = narrow(size_), kd = narrow(bandwidth_), ld = kd + 1;
  int info = 0;
  std::vector<double> diagonal(static_cast<std::size_t>(size_));
  for (Index j = 0; j < size_; ++j) diagonal[j] = data_[j * ld];
  if (bandwidth_ <= kNarrow)
    info = factor_narrow_band(data_.data(), size_, bandwidth_) ? 0 : 1;
  else
    dpbtrf_("L", &n, &kd, data_.data(), &ld, &info);
  if (info != 0) return false;
  // A pivot that is rounding of its diagonal, or no number.
  for (Index j = 0; j < size_; ++j) {
    const double pivot = data_[j * ld];
    if (!(pivot * pivot > least_pivot * diagonal[j])) return false;
  }
  return true;
}

void BandMatrix::solve(double* x, Index columns) const {
  const int n = narrow(size_), kd = narrow(bandwidth_), ld = kd + 1, rhs = narrow(columns);
  int info = 0;
  AlignedVector<double> aligned(x, x + size_ * columns);
  dpbtrs_("L", &n, &kd, &rhs, data_.data(), &ld, aligned.data(), &n, &info);
  std::copy(aligned.begin(), aligned.end(), x);
}

void BandMatrix::forward(Panel& x) const {
  parallel_for(x.blocks(), [&](Index b) { forward_block(data_.data(), size_, bandwidth_, x.block(b)); });
}

void Panel::add_gram(Index begin, Index count, double factor, double* matrix) const {
  if (count == 0) return;
  const Index first = begin / kBlock, last = (begin + count - 1) / kBlock;
  double products[kBlock * kBlock];
  for (Index a = first; a <= last; ++a)
    for (Index b = first; b <= a; ++b) {
      block_products(block(a), block(b), rows_, products);
      for (Index i = 0; i < kBlock; ++i)
        for (Index j = 0; j < kBlock; ++j) {
          const Index row = a * kBlock + i - begin, column = b * kBlock + j - begin;
          if (row < 0 || row >= count || column < 0 || column >= count) continue;
          matrix[row * count + column] += factor * products[i * kBlock + j];
          if (a != b) matrix[column * count + row] += factor * products[i * kBlock + j];
        }
    }
}

double BandMatrix::condition(double norm) const {
  const int n = narrow(size_), kd = narrow(bandwidth_), ld = kd + 1;
  AlignedVector<double> work(static_cast<std::size_t>(3 * size_));
  std::vector<int> iwork(static_cast<std::size_t>(size_));
  double reciprocal = 0;
  int info = 0;
  dpbcon_("L", &n, &kd, data_.data(), &ld, &norm, &reciprocal, work.data(), iwork.data(), &info);
  return reciprocal > 0 ? 1 / reciprocal : std::numeric_limits<double>::infinity();
}

}  // namespace knotfit
