// A fit whose knots, weights and points may change: what optimises knots calls [METHOD 3.1].
#pragma once
#include <vector>

#include "fit/fit_problem.h"
#include "fit/knot_jacobian.h"
#include "solve/banded_system.h"
namespace knotfit {

/// Takes its points as scattered ones, whatever their layout.
class MovingFit : public FitProblem {
 public:
  /// \param points  outlive the fit, which keeps a reference
  /// \throws InvalidInput  as FitProblem
  MovingFit(const ParameterizedPoints& points, int degree_u, int degree_v,
            const LeastSquaresOptions& options = {});
  MovingFit(const ParameterizedPoints&& points, int degree_u, int degree_v,
            const LeastSquaresOptions& options = {}) = delete;

  /// Assembles and factors at these knots, as solve() does, and leaves net and residuals as they are.
  bool factor(const InteriorKnots& knots);
  /// Takes a net that need not minimise anything, with its residuals (stored order).
  void restore(std::vector<double> net, std::vector<double> residual);

  /// Of the last solve, in the knots. \param golub_pereyra  see knot_jacobian.h
  KnotJacobian jacobian(bool golub_pereyra = false) const;

  /// Weights of the next fits, in the stored order; empty: all 1.
  void set_weights(std::vector<double> weights) { banded().set_weights(std::move(weights)); }
  /// S - P of the last solve or evaluate, in the stored order, n x dimension.
  const std::vector<double>& residual() const { return system().residual(); }
  /// The stored order of the points.
  const CellOrder& order() const { return system().points(); }
  const BandedSystem& system() const { return static_cast<const BandedSystem&>(*system_); }

  /// The points it was made of have grown: takes the new ones in. Solve or evaluate before anything else.
  void take_new_points() { banded().append(points_, order().size()); }
  /// Only the first `points` of the points given count in the errors, their sums and the maximum.
  void count_first(Index points);

 private:
  BandedSystem& banded() { return static_cast<BandedSystem&>(*system_); }
};

}  // namespace knotfit
