// The whole way for curves in one call: ordered points in, one checked curve out.
//
//   knotfit::CurvePoints points = knotfit::parameterize_curve(xy, 2, knotfit::RowSpacing::chord, true);
//   knotfit::CurveFitOptions options;
//   options.tolerance = {.value = 0.01};
//   knotfit::CurveFitResult result = knotfit::fit_curve(points, options);
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/curve.h"
#include "knotfit/curve_points.h"
#include "knotfit/fit_surface.h"
namespace [[gnu::visibility("default")]] knotfit {

struct CurveFitOptions {
  std::optional<ToleranceRequest> tolerance;
  int control_points = 0;  ///< a fixed size; 0: sizes are searched to the tolerance
  /// Knots given: interior ones of [0,1]; of a closed curve all of one period, in [0,1).
  std::optional<std::vector<double>> knots;
  std::string method = "optimal";  ///< any placement method
  int degree = 3;                  ///< 1 to 9
  /// Rounds that move every parameter to the foot of its point on the curve [Hoschek88]; 0: as given.
  int corrections = 0;
  Index max_control_points = 0;  ///< 0: half of the points
  long max_fits = 0;             ///< 0: 100 000; one takes about 0.1 ms
  double smoothing = 1e-12;      ///< relative floor, as LeastSquaresOptions
  FeatureMeasure feature = FeatureMeasure::hessian;
  FeatureMap user_features;  ///< along t, the map's u; in place of `feature`; empty: none
  long evaluations = 2000;   ///< of the error, in an evolutionary search
};

struct CurveFitResult {
  Status status = Status::not_run;
  std::string message;
  Curve curve;  ///< clamped, over [0,1], in the data's own coordinates
  bool closed = false;
  /// Control points that were free: curve.size(), but of a closed curve as many as knots in a period.
  Index control_points = 0;
  std::vector<double> knots;   ///< interior, on [0,1]; of a closed curve the seam, 0, is one more
  std::vector<double> t;       ///< n, of each point on the curve
  std::vector<double> errors;  ///< n, rechecked, |C(t_k) - P_k|
  ErrorSummary error;
  double tolerance = 0;  ///< absolute; 0: none asked
  Tolerance asked;
  double diagonal = 0;           ///< of the bounding box; a function's range
  double measured = 0;           ///< the error that counts
  bool reached = false;          ///< at the points and between them
  SwingReport swings;            ///< whether the curve keeps to its data between the points; worst_u is its t
  std::string method;            ///< or "given"
  std::vector<SizeTried> tried;  ///< size_u control points, size_v 1
  long fits = 0;
  double noise = 0;  ///< estimated from the data; 0: none found
  std::vector<std::string> notes;
};

/// Validates, centres and scales, places knots or searches sizes (none after Control::time_limit), corrects
/// parameters, fits, rechecks. A closed curve
/// is placed as one cut open at its first point, which becomes a knot; `optimal` then moves all knots of the period.
/// \throws InvalidInput  see validate(), CurveFitOptions; names what to change
CurveFitResult fit_curve(const CurvePoints& points, const CurveFitOptions& options,
                         const Control& control = {});

}  // namespace knotfit
