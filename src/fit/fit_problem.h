// One set of points fitted again and again with other knots: what placement and searches call.
#pragma once
#include <memory>
#include <vector>

#include "knotfit/fit_least_squares.h"
#include "knotfit/interior_knots.h"
#include "knotfit/tolerance.h"
#include "solve/normal_system.h"
namespace knotfit {

/// The grid that fits of these points take: that of find_grid(), and none where points have weights.
GridLayout fitted_grid(const ParameterizedPoints& points);

/// Control points and errors of knots given. Knots that move need a MovingFit.
class FitProblem {
 public:
  /// \param points  outlive the problem, which keeps a reference
  /// \throws InvalidInput  points invalid (validate), degrees outside [1,9]
  FitProblem(const ParameterizedPoints& points, int degree_u, int degree_v,
             const LeastSquaresOptions& options = {});
  FitProblem(const ParameterizedPoints&& points, int degree_u, int degree_v,
             const LeastSquaresOptions& options = {}) = delete;
  FitProblem(const FitProblem&) = delete;  // the system refers to the axes inside
  FitProblem& operator=(const FitProblem&) = delete;

  /// Least squares on these knots. \return false where no smoothing makes it solvable: rms, max are
  /// then infinite
  bool solve(const InteriorKnots& knots);
  /// Takes any net on these knots and measures its residuals; nothing is factored.
  void evaluate(const InteriorKnots& knots, std::vector<double> net);

  // Of the last solve or evaluate:
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
  double condition() const { return system_->condition(); }
  double smoothing() const { return system_->smoothing(); }
  Index empty_cells() const { return system_->empty_cells(); }

  const ParameterizedPoints& points() const { return points_; }
  int degree_u() const { return degree_u_; }
  int degree_v() const { return degree_v_; }
  bool on_grid() const { return on_grid_; }
  Index counted() const {
    return counted_;
  }  ///< points that the errors and their sums are of, the first ones
  Index control_points() const { return u_.functions() * v_.functions(); }
  long fits() const { return fits_; }
  /// Most functions that the data can tell apart in a direction: grid lines, or points.
  Index most_functions_u() const { return most_u_; }
  Index most_functions_v() const { return most_v_; }
  /// Multiplications of one fit of that many functions, roughly: what budgets count.
  double operations(Index functions_u, Index functions_v) const;
  /// Refinement steps of every solve from here on: 0 while searching, as they cost a pass each.
  void set_refinement_steps(int steps) { options_.refinement_steps = steps; }

 protected:
  void set_knots(const InteriorKnots& knots);
  void take(const ResidualSums& sums);

  const ParameterizedPoints& points_;
  int degree_u_, degree_v_;
  LeastSquaresOptions options_;
  bool on_grid_ = false;
  Index most_u_ = 0, most_v_ = 0;
  Index counted_;  ///< points that the sums are of
  std::unique_ptr<NormalSystem> system_;
  InteriorKnots knots_;
  Axis u_, v_;
  std::vector<double> net_;
  double rms_ = 0, max_ = 0, phi_ = 0;
  long fits_ = 0;
};

}  // namespace knotfit
