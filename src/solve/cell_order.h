// Scattered points in structure-of-arrays form, sorted by knot cell.
#pragma once
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "knotfit/points.h"
#include "solve/axis.h"
namespace knotfit {

/// A run of points of one cell, at most kChunk long: the unit of parallel work. Fixed by the data
/// and the knots, never by the threads.
struct CellPiece {
  Index cell = 0, begin = 0, end = 0;
};

class CellOrder {
 public:
  explicit CellOrder(const ParameterizedPoints& points);

  /// Takes the points from `first` on, behind all others in the stored order; sort again after it.
  void append(const ParameterizedPoints& points, Index first);

  /// Sorts by the cells outer span * inner.spans() + inner span.
  /// \param swapped  outer runs along v
  void sort(const Axis& outer, const Axis& inner, bool swapped);

  Index size() const { return static_cast<Index>(input_.size()); }
  int dimension() const { return dimension_; }
  // By position in cell order:
  /// Place in the stored order, which no knots change: residuals and weights are kept in it.
  Index stored(Index k) const { return order_[k]; }
  double outer(Index k) const { return outer_[k]; }  ///< local coordinate in [-1,1]
  double inner(Index k) const { return inner_[k]; }
  const double* value(Index k) const { return values_.data() + Index{order_[k]} * dimension_; }
  double weight(Index k) const { return weights_.empty() ? 1.0 : weights_[order_[k]]; }
  // By place in the stored order:
  Index input(Index i) const { return input_[i]; }  ///< index in the points given
  double stored_u(Index i) const { return u_[i]; }
  double stored_v(Index i) const { return v_[i]; }
  const double* stored_value(Index i) const { return values_.data() + i * dimension_; }
  const std::vector<double>& weights() const { return weights_; }  ///< empty: all 1
  void set_weights(std::vector<double> weights) { weights_ = std::move(weights); }
  const std::vector<CellPiece>& pieces() const { return pieces_; }
  /// Pieces of cell c: pieces()[piece_start()[c] .. piece_start()[c+1]).
  const std::vector<Index>& piece_start() const { return piece_start_; }
  Index empty_cells() const { return empty_cells_; }

 private:
  int dimension_;
  std::vector<double> u_, v_, values_, weights_;  ///< sorted once by a background grid
  std::vector<std::int32_t> input_;
  std::vector<std::int32_t> order_, cell_;
  std::vector<double> outer_, inner_;
  std::vector<CellPiece> pieces_;
  std::vector<Index> piece_start_;
  Index empty_cells_ = 0;
};

}  // namespace knotfit
