// The whole way in one call: points with parameters in, one checked surface out.
//
//   knotfit::FitOptions options;
//   options.tolerance = {.value = 0.1, .relative = true};   // 0.1 % of the diagonal
//   knotfit::FitResult result = knotfit::fit_surface(points, options);
//   if (result.status == knotfit::Status::reached) use(result.surface);
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/fit_least_squares.h"
#include "knotfit/points.h"
#include "knotfit/refine.h"
#include "knotfit/verify.h"
namespace [[gnu::visibility("default")]] knotfit {

struct ToleranceRequest {
  double value = 0;       ///< > 0
  bool relative = false;  ///< in % of bounding_diagonal (height fields: of the range of heights)
  ErrorMeasure measure = ErrorMeasure::max;
  double share = 1;  ///< of the points, for ErrorMeasure::percentile
};

struct FitOptions : SearchOptions {
  std::optional<ToleranceRequest> tolerance;
  /// A fixed size in control points (u, v); 0: sizes are searched to the tolerance.
  int control_points_u = 0, control_points_v = 0;
  /// Interior knots given; their size is fixed by them.
  std::optional<InteriorKnots> knots;
  /// Degrees 3, 4 and 5 are tried, equal ones and then one direction apart, and the fewest control points win
  /// (at a fixed size: the least error). Not with given knots.
  bool degree_auto = false;
  bool between = true;  ///< measure the honest numbers between the data
};

/// Other knots at the same size, by plain least squares.
struct Comparison {
  double error = 0;           ///< the error that counts there; 0: not compared
  double control_points = 0;  ///< the same knots would need about so many for the error of the result, by the
                              ///< order of the spline: size * (error / reached)^(2 / (degree + 1))
};

struct FitResult {
  Status status = Status::not_run;
  std::string message;  ///< the status in a sentence, with its figures
  Surface surface;      ///< in the data's own coordinates, over [0,1]^2
  ParameterMap map;     ///< to the user's parameters
  bool height_field = false;
  double tolerance = 0;        ///< absolute; 0: none asked
  Tolerance asked;             ///< absolute value, measure, share
  double diagonal = 0;         ///< the unit of a relative tolerance
  double measured = 0;         ///< the error that counts, rechecked
  bool reached = false;        ///< verdict from the rechecked residuals and the swings
  std::vector<double> errors;  ///< n, rechecked, input order
  Index left_out = 0;  ///< points of the input that were merged or left out of the fit (judge_all_points)
  double all_max = 0;  ///< the largest error of all points of the input, where some were
  ErrorSummary error;
  double condition = 0;
  double smoothing = 0;
  Index empty_cells = 0;
  double recheck_difference = 0;  ///< largest |rechecked - fitted| error
  SwingReport swings;             ///< whether the surface keeps to its data where points stand side by side
  BetweenReport between;
  std::string method;  ///< placement method, or "given"
  Effort effort = Effort::balanced;
  bool least_squares = true;  ///< false: the control points minimise the maximum, or hold fill points too
  Index fill_points = 0;      ///< places between the data that the search held the surface at
  Index sample = 0;           ///< points of the sample that the knots were placed or moved on; 0: all
  Comparison against_uniform, against_error_model;  ///< what optimised knots saved; of "optimal" alone
  double criterion = 0;                             ///< E(U,V), where the method has one
  std::vector<SizeTried> tried;
  long fits = 0;
  double noise = 0;                ///< estimated from the data; 0: none found
  std::vector<std::string> notes;  ///< what a user should know, a sentence each
};

/// Validates, centres and scales, places knots or searches sizes, fits, rechecks, measures between.
/// \throws InvalidInput  see validate(), FitOptions; names what to change
FitResult fit_surface(const ParameterizedPoints& points, const FitOptions& options,
                      const Control& control = {});

/// The verdict over all points of an input, of which some were merged or left out before the fit: measured, reached, status and
/// message become those of all; errors stay those of the points fitted.
/// \param errors  |S - P| of every point of the input, at least as many as were fitted
/// \throws InvalidInput  fewer errors, or one that is negative or not finite
void judge_all_points(FitResult& result, const std::vector<double>& errors);

}  // namespace knotfit
