// Symmetric positive definite band matrices: LAPACK behind one small interface.
#pragma once
#include <vector>

#include "knotfit/index.h"
namespace knotfit {

/// Lower band storage: entry (i, j), j <= i <= j + bandwidth, at [j * (bandwidth + 1) + i - j].
class BandMatrix {
 public:
  BandMatrix() = default;
  BandMatrix(Index size, Index bandwidth) { reset(size, bandwidth); }
  void reset(Index size, Index bandwidth);  ///< all zero
  Index size() const { return size_; }
  Index bandwidth() const { return bandwidth_; }
  double* column(Index j) { return data_.data() + j * (bandwidth_ + 1); }
  void add(Index i, Index j, double value) { data_[j * (bandwidth_ + 1) + i - j] += value; }
  double trace() const;
  double norm_1() const;  ///< largest column sum of the full symmetric matrix
  /// Cholesky factor in place (dpbtrf). \return false where the matrix is not positive definite
  bool factor();
  /// Solves with the factor in place; x is size x columns, column after column (dpbtrs).
  void solve(double* x, Index columns) const;
  /// x <- L^-1 x with the factor L (dtbtrs).
  void forward(double* x, Index columns) const;
  /// 1-norm condition estimate from the factor (dpbcon). \param norm  norm_1() before factor()
  double condition(double norm) const;

 private:
  Index size_ = 0, bandwidth_ = 0;
  std::vector<double> data_;
};

}  // namespace knotfit
