// One curve fitted again and again with other knots, open or closed [METHOD 9.1].
#pragma once
#include <memory>
#include <vector>

#include "knotfit/curve.h"
#include "knotfit/curve_points.h"
#include "knotfit/tolerance.h"
#include "solve/data_energy.h"
namespace knotfit {

/// Knots of an open curve are interior ones of [0,1]; of a closed curve all of one period, increasing, from the seam
/// on: p_0 in [0,1), p_{n-1} < p_0 + 1. It has as many control points.
class CurveProblem {
 public:
  /// \param points  valid; their parameters may be changed between solves
  /// \param energy  of the curve's strip (strip_raster), or none
  CurveProblem(CurvePoints points, int degree, double smoothing,
               std::shared_ptr<const DataEnergy> energy = nullptr);
  CurvePoints& points() { return points_; }
  const CurvePoints& points() const { return points_; }
  int degree() const { return degree_; }

  /// Least squares with a relative smoothing floor, its share taken out by one refinement step, as surfaces have it.
  /// \return false where it cannot be solved, or a closed curve has not degree + 1 knots
  bool solve(const std::vector<double>& knots);
  // Of the last solve:
  const std::vector<double>& knots() const { return knots_; }
  double phi() const { return phi_; }                         ///< sum w |r|^2
  const std::vector<double>& residual() const { return r_; }  ///< n x dimension, times the root of the weight
  std::vector<double> errors() const;                         ///< n, |C(t_k) - P_k|
  double measured(const Tolerance& tolerance) const;
  /// Over [0,1]; closed: over one period from the seam on, its knots periodic, control points repeated.
  const Curve& curve() const { return curve_; }
  /// t as a parameter of curve().
  double on_curve(double t) const;
  long fits() const { return fits_; }

 private:
  CurvePoints points_;
  int degree_;
  double smoothing_, mean_weight_ = 1;
  std::shared_ptr<const DataEnergy> energy_;
  std::vector<double> knots_, r_;
  Curve curve_;
  double phi_ = 0;
  long fits_ = 0;
};

}  // namespace knotfit
