// Levenberg-Marquardt on the knots, control points eliminated [Golub73; Kaufman75; METHOD 3.2].
#pragma once
#include <functional>
#include <optional>

#include "fit/knot_jacobian.h"
#include "fit/moving_fit.h"
#include "place/knot_spacings.h"
namespace knotfit {

struct LevenbergOptions {
  int steps = 40;             ///< at most
  double least_span = 0.005;  ///< of the mean span; 15 % costs two thirds more control points on a step
  double fall = 1e-3;         ///< two relative falls of phi below this end it
  /// Ends where five more steps as good as the last would not bring phi below it; 0: none.
  double target = 0;
  bool golub_pereyra = false;  ///< the exact Jacobian: no better optima, 1.5 times the cost
  std::function<bool()> stop;  ///< asked between steps; may be empty
};

/// Normal equations of one step in the log-spacings of both directions [Jupp78]: H = C^T J^T W J C, g = C^T J^T W r.
class SpacingStep {
 public:
  /// \param jacobian  J^T W J and J^T W r in the knots
  SpacingStep(const KnotJacobian& jacobian, const InteriorKnots& knots);
  /// Of a problem that holds a net with its residuals and the factor of its weights.
  SpacingStep(MovingFit& problem, const InteriorKnots& knots, bool golub_pereyra, double scale_matrix = 1,
              double scale_gradient = 1);
  /// Solves with damping mu; no entry beyond `most`. \return false where the matrix is singular
  bool solve(double mu, double most);
  InteriorKnots moved(double least_span) const;
  double predicted_fall() const;  ///< of the quadratic model, for the step last solved

 private:
  struct Scales {
    double matrix, gradient;
  };
  SpacingStep(const KnotJacobian& jacobian, const InteriorKnots& knots, std::optional<Scales> scales);

  KnotSpacings u_, v_;
  std::size_t unknowns_ = 0;
  std::vector<double> matrix_, gradient_, step_;
};

/// Minimises phi over the knots from `knots`; equal knots move as one. The problem holds the fit of
/// the result. \return phi there; infinity where the start cannot be fitted
double minimize_over_knots(MovingFit& problem, InteriorKnots& knots, const LevenbergOptions& options = {});

}  // namespace knotfit
