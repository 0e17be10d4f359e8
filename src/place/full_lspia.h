// Progressive iteration on control points and knots, and knots removed while a tolerance holds [Lan24].
#pragma once
#include <functional>
#include <vector>

#include "fit/fit_problem.h"
namespace knotfit {

struct FullLspiaOptions {
  int rounds = 40;             ///< at most; each one line search on the knots
  int net_steps = 12;          ///< LSPIA steps on the control points a round
  double fall = 1e-4;          ///< two rounds of a smaller relative fall end it
  double least_span = 0.01;    ///< of the mean
  std::function<bool()> stop;  ///< asked between rounds; may be empty
};

/// Rounds from `knots`, whose least squares are the first control points.
/// \return phi of the start and after each round: it never rises
std::vector<double> full_lspia(FitProblem& problem, InteriorKnots& knots,
                               const FullLspiaOptions& options = {});

/// Drops the knot whose loss is least, of either direction, while `holds()` is true of the fit without it and more
/// than (interior_u, interior_v) are left; the problem holds the fit of what is left.
void remove_least_knots(FitProblem& problem, InteriorKnots& knots, int interior_u, int interior_v,
                        const std::function<bool()>& holds, const std::function<bool()>& stop = {});

}  // namespace knotfit
