// Points that fill a tensor grid with equal weights: the normal matrix is a Kronecker product, so
// each direction is solved on its own (exact) [METHOD 6.2].
#pragma once
#include "solve/banded.h"
#include "solve/normal_system.h"
namespace knotfit {

class KroneckerSystem final : public NormalSystem {
 public:
  /// \param grid  not empty (find_grid)
  KroneckerSystem(const ParameterizedPoints& points, GridLayout grid);
  void arrange(const Axis& u, const Axis& v) override;
  bool factor(const Axis& u, const Axis& v, double relative_smoothing) override;
  std::vector<double> project_data() override { return project(values_); }
  std::vector<double> project_residual() override { return project(residual_); }
  ResidualSums residuals(const std::vector<double>& net) override;
  std::vector<double> errors() const override;
  /// Product of the two directions' estimates: the condition of a Kronecker product.
  double condition() const override;

 private:
  /// One direction: basis values at the grid lines and the factored normal matrix.
  struct Direction {
    std::vector<Index> first;    ///< first function alive at each line
    std::vector<double> values;  ///< lines x width
    int width = 0;
    Index functions = 0;
    Index empty_spans = 0, used_spans = 0;
    BandMatrix matrix;
    double norm = 0, smoothing = 0;
  };
  static void arrange(Direction& direction, const Axis& axis, const std::vector<double>& lines);
  bool factor(Direction& direction, const Axis& axis, double relative);
  std::vector<double> project(const std::vector<double>& x) const;

  int dimension_;
  GridLayout grid_;
  std::vector<double> values_, residual_;  ///< size_u x size_v x dimension
  Direction u_, v_;
};

}  // namespace knotfit
