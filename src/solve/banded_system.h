// The normal equations of scattered points, assembled cell by cell from moments [METHOD 1.3, 6.1].
#pragma once
#include <memory>

#include "solve/banded.h"
#include "solve/cell_order.h"
#include "solve/data_energy.h"
#include "solve/normal_system.h"
namespace knotfit {

class BandedSystem final : public NormalSystem {
 public:
  explicit BandedSystem(const ParameterizedPoints& points,
                        std::shared_ptr<const DataEnergy> energy = nullptr);
  bool factor(const Axis& u, const Axis& v, double relative_smoothing) override;
  /// Sorts the points into the cells of these knots.
  void arrange(const Axis& u, const Axis& v) override;
  std::vector<double> project_data() override { return project(false); }
  std::vector<double> project_residual() override { return project(true); }
  ResidualSums residuals(const std::vector<double>& net) override;
  std::vector<double> errors() const override;
  double condition() const override { return matrix_.condition(norm_); }

  const CellOrder& points() const { return order_; }
  /// Weights of the next fits, in the stored order.
  void set_weights(std::vector<double> weights) { order_.set_weights(std::move(weights)); }
  /// More points of the same data, from index `first` on, behind the others in the stored order.
  void append(const ParameterizedPoints& points, Index first) {
    order_.append(points, first);
    arranged_u_ = arranged_v_ = {};
    residual_.clear();
  }
  /// Only the first `points` of the points given count in the sums of squares and the maximum.
  void count_first(Index points) { counted_ = points; }
  Index counted() const { return counted_; }
  /// S - P of the last residuals() call, in the stored order.
  const std::vector<double>& residual() const { return residual_; }
  /// Replaces it; the sums are those of residuals().
  ResidualSums set_residual(std::vector<double> residual);

  // Of the matrix last factored, for what follows from it:
  /// The direction with more functions: the band is narrower so.
  const Axis& outer() const { return *outer_; }
  const Axis& inner() const { return *inner_; }
  bool swapped() const { return swapped_; }  ///< outer runs along v
  const BandMatrix& matrix() const { return matrix_; }
  /// sum w P_a(t) P_b(s) over the points of a cell that has some, outer moments x padded inner moments.
  const double* cell_moments(Index cell) const {
    return moments_.data() + order_.piece_start()[cell] * moments_a_piece_;
  }

 private:
  std::vector<double> project(bool residual);
  void add_smoothing(double relative);
  double squared(Index stored) const;  ///< |r|^2
  ResidualSums sums_of(Index stored) const;

  double mean_weight() const;

  CellOrder order_;
  std::shared_ptr<const DataEnergy> energy_;
  std::vector<double> net_;  ///< of the last residuals() call, where there is an energy
  const Axis* outer_ = nullptr;
  const Axis* inner_ = nullptr;
  bool swapped_ = false;
  KnotVector arranged_u_, arranged_v_;  ///< knots of the present order
  Index counted_;
  BandMatrix matrix_;
  double norm_ = 0;
  /// A piece: matrix, then right side. A cell's first piece ends with the cell's sums.
  std::vector<double> moments_;
  Index moments_a_piece_ = 0;
  std::vector<double> residual_;  ///< stored order, n x dimension
  std::vector<double> data_rhs_;  ///< A^T W P, gathered in the pass that makes the moments
};

}  // namespace knotfit
