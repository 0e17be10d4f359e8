// Symmetric positive definite band matrices: LAPACK behind one small interface.
#pragma once
#include <limits>
#include <vector>

#include "base/aligned.h"
#include "knotfit/index.h"
namespace knotfit {

/// Columns of right-hand sides, side by side in blocks of 8, so that one pass over the factor serves a block.
class Panel {
 public:
  static constexpr Index kBlock = 8;
  Panel(Index rows, Index columns)
      : rows_(rows), columns_(columns), data_(rows * kBlock * ((columns + kBlock - 1) / kBlock), 0.0) {}
  Index rows() const { return rows_; }
  Index columns() const { return columns_; }
  double& operator()(Index row, Index column) {
    return data_[(column / kBlock * rows_ + row) * kBlock + column % kBlock];
  }
  double* block(Index b) { return data_.data() + b * rows_ * kBlock; }
  const double* block(Index b) const { return data_.data() + b * rows_ * kBlock; }
  Index blocks() const { return (columns_ + kBlock - 1) / kBlock; }
  /// Adds factor * X^T X of columns begin..begin+count-1 to matrix, count x count.
  void add_gram(Index begin, Index count, double factor, double* matrix) const;

 private:
  Index rows_, columns_;
  std::vector<double> data_;
};

/// Lower band storage: entry (i, j), j <= i <= j + bandwidth, at [j * (bandwidth + 1) + i - j].
class BandMatrix {
 public:
  BandMatrix() = default;
  BandMatrix(Index size, Index bandwidth) { reset(size, bandwidth); }
  void reset(Index size, Index bandwidth);  ///< all zero
  Index size() const { return size_; }
  Index bandwidth() const { return bandwidth_; }
  double* column(Index j) { return data_.data() + j * (bandwidth_ + 1); }
  const double* column(Index j) const { return data_.data() + j * (bandwidth_ + 1); }
  /// Of the same size and bandwidth.
  void add(const BandMatrix& other) {
    for (std::size_t i = 0; i < data_.size(); ++i) data_[i] += other.data_[i];
  }
  void add(Index i, Index j, double value) { data_[j * (bandwidth_ + 1) + i - j] += value; }
  /// y = A x of the full symmetric matrix, before factor(); size x columns each, column after column.
  std::vector<double> times(const std::vector<double>& x) const;
  double trace() const;
  double norm_1() const;  ///< largest column sum of the full symmetric matrix
  /// Cholesky factor in place (dpbtrf where the band is wide).
  /// \param least_pivot  of a pivot's square over its diagonal: below it is rounding
  /// \return false where the matrix is not positive definite to that precision
  bool factor(double least_pivot = 8 * std::numeric_limits<double>::epsilon());
  /// Solves with the factor in place; x is size x columns, column after column (dpbtrs).
  void solve(double* x, Index columns) const;
  /// x <- L^-1 x with the factor L.
  void forward(Panel& x) const;
  /// 1-norm condition estimate from the factor (dpbcon). \param norm  norm_1() before factor()
  double condition(double norm) const;

 private:
  Index size_ = 0, bandwidth_ = 0;
  AlignedVector<double> data_;
};

}  // namespace knotfit
