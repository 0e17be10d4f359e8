// What both routes to a tolerance share: the best surface so far, budgets, stop and progress.
#pragma once
#include <chrono>
#include <string_view>

#include "fit/problem.h"
#include "knotfit/refine.h"
namespace knotfit {

class Attempts {
 public:
  Attempts(FitProblem& problem, const RefineOptions& options, const Control& control);

  /// Fits on these knots and keeps them if they are the best so far. \return the error that counts
  double fit(const InteriorKnots& knots);
  /// Takes the problem's last solve as fit() would.
  double take();
  bool holds(double error) const { return error <= options_.tolerance.value; }
  /// A size is done with: listed in the result, reported to the caller.
  void list(Index functions_u, Index functions_v, double error);

  /// Stopped, out of time or out of fits; the status says which.
  bool interrupted();
  Status interruption() const { return interruption_; }
  void set_stage(std::string_view stage) { stage_ = stage; }

  Index max_control_points() const { return max_control_points_; }
  bool own_limit() const { return options_.max_control_points > 0; }  ///< the caller's, not the default
  const Tolerance& tolerance() const { return options_.tolerance; }
  FitProblem& problem() { return problem_; }
  /// Fewer than half the points, and the data's own count where it fills a grid.
  bool allowed(Index functions_u, Index functions_v) const;

  /// Best: the fewest control points that hold, else the least error.
  RefineResult finish(Status unmet) const;
  bool reached() const { return best_holds_; }
  const InteriorKnots& best() const { return best_; }

 private:
  void report();
  FitProblem& problem_;
  const RefineOptions& options_;
  const Control& control_;
  Index max_control_points_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::string_view stage_;
  Status interruption_ = Status::not_run;
  InteriorKnots best_;
  bool best_holds_ = false;
  double best_error_;
  Index best_size_ = 0;
  std::vector<SizeTried> tried_;
};

/// The routes. \return knots of the best surface, its status and what was tried
RefineResult search_sizes(FitProblem& problem, const RefineOptions& options, const Control& control);
RefineResult insert_isolines(FitProblem& problem, const RefineOptions& options, const Control& control);

/// Default limit on control points: half the points; for scattered data at most 50 000, since their
/// band matrix grows with the power 3/2.
Index default_control_points(const FitProblem& problem);

/// The residual's RMS only follows the noise: two sizes in a row gain no more than control points
/// gain on white noise, near the noise level found in the data.
class NoisePlateau {
 public:
  NoisePlateau(double noise, Index points, int dimension);
  /// \return true where the sizes so far say so
  bool add(Index control_points, double rms);

 private:
  double level_, points_;
  double last_size_ = 0, last_rms_ = 0;
  int flat_ = 0;
};

}  // namespace knotfit
