// The normal equations of a fit, whatever the layout of its data.
#pragma once
#include <vector>

#include "knotfit/points.h"
#include "solve/axis.h"
namespace knotfit {

struct ResidualSums {
  double squares = 0;   ///< sum |r|^2, weights left out
  double weighted = 0;  ///< sum w |r|^2
  double max = 0;       ///< largest |r|
  ResidualSums& operator+=(const ResidualSums& o) {
    squares += o.squares;
    weighted += o.weighted;
    if (!(o.max <= max)) max = o.max;  // a NaN stays
    return *this;
  }
};

/// Points in a layout of their own, with the normal matrix G = A^T W A + lambda J of one pair of axes. Its axes outlive the
/// calls that follow those that name them.
class NormalSystem {
 public:
  virtual ~NormalSystem() = default;
  /// What residuals() needs of these axes; nothing is factored.
  virtual void arrange(const Axis& u, const Axis& v) = 0;
  /// Arranges, assembles and factors. \return false where the matrix is not positive definite
  virtual bool factor(const Axis& u, const Axis& v, double relative_smoothing) = 0;
  /// G^-1 A^T W x for x the data, or the residual of the last residuals() call.
  /// \return size_u x size_v x dimension
  virtual std::vector<double> project_data() = 0;
  virtual std::vector<double> project_residual() = 0;
  /// r = S - P at every point for the net given; kept inside.
  virtual ResidualSums residuals(const std::vector<double>& net) = 0;
  /// |r| of every point in input order.
  virtual std::vector<double> errors() const = 0;
  /// Condition estimate of the matrix last factored; needs keep_norm(true) before factor().
  virtual double condition() const = 0;
  void keep_norm(bool keep) { keep_norm_ = keep; }
  double smoothing() const { return smoothing_; }
  Index empty_cells() const { return empty_cells_; }

 protected:
  bool keep_norm_ = false;
  double smoothing_ = 0;
  Index empty_cells_ = 0;
};

}  // namespace knotfit
