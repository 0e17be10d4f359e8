#include "fit/banded.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/narrow.h"

extern "C" {
void dpbtrf_(const char* uplo, const int* n, const int* kd, double* ab, const int* ldab, int* info);
void dpbtrs_(const char* uplo, const int* n, const int* kd, const int* nrhs, const double* ab,
             const int* ldab, double* b, const int* ldb, int* info);
void dtbtrs_(const char* uplo, const char* trans, const char* diag, const int* n, const int* kd,
             const int* nrhs, const double* ab, const int* ldab, double* b, const int* ldb, int* info);
void dpbcon_(const char* uplo, const int* n, const int* kd, const double* ab, const int* ldab,
             const double* anorm, double* rcond, double* work, int* iwork, int* info);
// Where the LAPACK is OpenBLAS: its own threads change the bits and, on a busy machine, are
// 20 times slower than one.
void openblas_set_num_threads(int) __attribute__((weak));
}

namespace knotfit {
namespace {

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

bool BandMatrix::factor() {
  one_blas_thread();
  const int n = narrow(size_), kd = narrow(bandwidth_), ld = kd + 1;
  int info = 0;
  dpbtrf_("L", &n, &kd, data_.data(), &ld, &info);
  if (info != 0) return false;
  for (Index j = 0; j < size_; ++j)
    if (!std::isfinite(data_[j * (bandwidth_ + 1)])) return false;
  return true;
}

void BandMatrix::solve(double* x, Index columns) const {
  const int n = narrow(size_), kd = narrow(bandwidth_), ld = kd + 1, rhs = narrow(columns);
  int info = 0;
  dpbtrs_("L", &n, &kd, &rhs, data_.data(), &ld, x, &n, &info);
}

void BandMatrix::forward(double* x, Index columns) const {
  const int n = narrow(size_), kd = narrow(bandwidth_), ld = kd + 1, rhs = narrow(columns);
  int info = 0;
  dtbtrs_("L", "N", "N", &n, &kd, &rhs, data_.data(), &ld, x, &n, &info);
}

double BandMatrix::condition(double norm) const {
  const int n = narrow(size_), kd = narrow(bandwidth_), ld = kd + 1;
  std::vector<double> work(static_cast<std::size_t>(3 * size_));
  std::vector<int> iwork(static_cast<std::size_t>(size_));
  double reciprocal = 0;
  int info = 0;
  dpbcon_("L", &n, &kd, data_.data(), &ld, &norm, &reciprocal, work.data(), iwork.data(), &info);
  return reciprocal > 0 ? 1 / reciprocal : std::numeric_limits<double>::infinity();
}

}  // namespace knotfit
