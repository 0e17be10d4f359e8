// Control points for given knots: linear least squares on scattered or gridded weighted data.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/points.h"
#include "knotfit/surface.h"
namespace knotfit {  // not exported

struct IndexedPoints;  // data/indexed_points.h

/// What holds a surface to its data where hardly any point does: an energy whose weights follow the data's own spacing,
/// its roughness and the errors that are all the same to the caller, and no knots [METHOD 5.1].
class DataEnergy;

}  // namespace knotfit

namespace [[gnu::visibility("default")]] knotfit {

/// \param scale    > 0, errors of this size are all the same: the tolerance
/// \param indexed  of these points, where they were indexed already; null: indexed here
/// \throws InvalidInput  points invalid, scale not positive and finite
std::shared_ptr<const DataEnergy> make_data_energy(const ParameterizedPoints& points, double scale,
                                                   std::shared_ptr<const IndexedPoints> indexed = {});

struct LeastSquaresOptions {
  /// Relative smoothing floor: lambda = smoothing * tr(A^T W A) / tr(J), J the thin-plate energy
  /// [METHOD 1.2] (degree 1: the membrane energy). Keeps cells without data alive. An absolute lambda
  /// biases steep data (9 times the error on a tanh(80 x) step); a relative 1e-9 leaves 4e-8.
  double smoothing = 1e-9;
  /// Steps c -= G^-1 A^T W r that take lambda's share of the error to rounding where data is.
  int refinement_steps = 1;
  /// Estimate the condition number of the normal matrix (costs a few solves).
  bool estimate_condition = true;
  /// Of these points, or none. Knots so close that a function hardly meets data leave it nearly free, and the surface
  /// swings between the points: this weighs there, and hardly anywhere else. Not where the data fills a grid.
  std::shared_ptr<const DataEnergy> energy{};
  /// Use the direction-by-direction solver where the data fills a grid with equal weights.
  bool use_grid = true;
};

/// How far a surface is from its points; an error is |S(u_k,v_k) - P_k| >= 0.
struct ErrorSummary {
  double rms = 0, max = 0, mean = 0;
  double median = 0, p95 = 0, p99 = 0, p995 = 0;  ///< least e with at least that share <= e
  Index worst = -1;                               ///< index of the point with the largest error
  double worst_u = 0, worst_v = 0;
};
/// \throws InvalidInput  no errors, or one is not finite (names its index)
ErrorSummary summarize_errors(const std::vector<double>& errors, const ParameterizedPoints& points);
/// Least e such that at least `share` in (0,1] of the errors are <= e.
double error_quantile(std::vector<double> errors, double share);

enum class FitStatus { not_run, solved, singular };
struct LeastSquaresResult {
  FitStatus status = FitStatus::not_run;
  Surface surface;
  std::vector<double> errors;  ///< n, |S - P| of each point in input order
  ErrorSummary error;
  double smoothing = 0;   ///< the absolute lambda used
  double condition = 0;   ///< 1-norm condition estimate of A^T W A + lambda J; 0: not asked
  Index empty_cells = 0;  ///< knot cells without a point
  bool on_grid = false;   ///< solved direction by direction
};

/// Minimises sum_k w_k |S(u_k,v_k) - P_k|^2 + lambda J(S) over the control points. [METHOD 1.2]
/// The same bits for any number of threads.
/// \throws InvalidInput  points invalid, knots not clamped on [0,1], fewer points than control points
LeastSquaresResult fit_least_squares(const ParameterizedPoints& points, const KnotVector& knots_u,
                                     const KnotVector& knots_v, const LeastSquaresOptions& options = {});

}  // namespace knotfit
