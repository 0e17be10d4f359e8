// One set of points fitted again and again with other knots: what placement and refinement call.
#pragma once
#include <memory>
#include <vector>

#include "fit/backend.h"
#include "knotfit/fit_least_squares.h"
#include "knotfit/interior_knots.h"
#include "knotfit/tolerance.h"
namespace knotfit {

class ScatteredBackend;

class FitProblem {
 public:
  /// \throws InvalidInput  points invalid (validate), degrees outside [1,9]
  FitProblem(const ParameterizedPoints& points, int degree_u, int degree_v,
             const LeastSquaresOptions& options = {});
  ~FitProblem();

  /// Least squares on these knots. \return false where no smoothing makes it solvable: rms, max are
  /// then infinite
  bool solve(const InteriorKnots& knots);

  // Of the last solve:
  const InteriorKnots& knots() const { return knots_; }
  const Axis& axis_u() const { return u_; }
  const Axis& axis_v() const { return v_; }
  const std::vector<double>& net() const { return net_; }  ///< size_u x size_v x dimension
  Surface surface() const;
  double rms() const { return rms_; }
  double max() const { return max_; }
  double phi() const { return phi_; }  ///< sum w |r|^2
  double measured(const Tolerance& tolerance) const;
  /// Of the points that count, in input order.
  std::vector<double> errors() const;
  double condition() const { return backend_->condition(); }
  double smoothing() const { return backend_->smoothing(); }
  Index empty_cells() const { return backend_->empty_cells(); }

  // For knots that move; needs LeastSquaresOptions::use_grid = false.
  /// The points' backend: weights, residuals, the Jacobian in the knots.
  ScatteredBackend& scattered();
  /// The points it was made of have grown: takes the new ones in. Solve or evaluate before anything else.
  void take_new_points();
  /// Assembles and factors at these knots, as solve() does, and leaves net and residuals as they are.
  bool factor(const InteriorKnots& knots);
  /// Takes any net on these knots and measures its residuals; nothing is factored.
  void evaluate(const InteriorKnots& knots, std::vector<double> net);
  /// Takes a net that need not minimise anything, with its residuals (stored order).
  void restore(std::vector<double> net, std::vector<double> residual);

  const ParameterizedPoints& points() const { return points_; }
  int degree_u() const { return degree_u_; }
  int degree_v() const { return degree_v_; }
  bool on_grid() const { return on_grid_; }
  Index control_points() const { return u_.functions() * v_.functions(); }
  long fits() const { return fits_; }
  /// Most functions that the data can tell apart in a direction: grid lines, or points.
  Index most_functions_u() const { return most_u_; }
  Index most_functions_v() const { return most_v_; }
  /// Floating-point operations of one fit of that many functions, roughly: what budgets count.
  double work(Index functions_u, Index functions_v) const;
  /// Refinement steps of every solve from here on: 0 while searching, as they cost a pass each.
  void set_refinement_steps(int steps) { options_.refinement_steps = steps; }

 private:
  void take(const ResidualSums& sums);
  const ParameterizedPoints& points_;
  int degree_u_, degree_v_;
  LeastSquaresOptions options_;
  bool on_grid_ = false;
  Index most_u_ = 0, most_v_ = 0;
  std::unique_ptr<FitBackend> backend_;
  ScatteredBackend* scattered_ = nullptr;  ///< backend_, where it is one
  InteriorKnots knots_;
  Axis u_, v_;
  std::vector<double> net_;
  double rms_ = 0, max_ = 0, phi_ = 0;
  long fits_ = 0;
};

}  // namespace knotfit
