// All data beside the sample of it that a search fits: the errors that count, and the exchange of its worst points
// [METHOD 6.4].
#pragma once
#include "fit/fit_problem.h"
#include "search/joined_points.h"
namespace knotfit {

class WholeData {
 public:
  /// \param all  the data; holds the surfaces that are measured
  WholeData(FitProblem& all, const Tolerance& tolerance) : all_(all), tolerance_(tolerance) {}

  /// Measures the surface that a problem over the sample holds at every point.
  /// \return the problem that holds it over all of them
  const FitProblem& measure(const FitProblem& sampled);
  /// Lets the worst points of the surface measured last join, of those beyond the tolerance: at most one a cell of a
  /// uniform grid, and some hundred in all. \return their number
  Index join_worst(JoinedPoints& joined) const;

 private:
  FitProblem& all_;
  Tolerance tolerance_;
};

}  // namespace knotfit
