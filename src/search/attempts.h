// What every route to a tolerance shares: the best surface so far, budgets, stop and progress.
#pragma once
#include <chrono>
#include <limits>
#include <string_view>

#include "fit/problem.h"
#include "knotfit/refine.h"
#include "verify/swings.h"
namespace knotfit {

class Attempts {
 public:
  /// \param data  the points themselves: their number and grid lines limit the sizes
  Attempts(const FitProblem& data, const RefineOptions& options, const Control& control, long max_fits);

  /// Another problem whose fits count.
  void count(const FitProblem& problem) { problems_.push_back(&problem); }
  long fits() const;

  /// Fits on these knots and offers the result. \return the error that counts
  double fit(FitProblem& problem, const InteriorKnots& knots);
  /// Keeps the surface the problem holds if it is the best so far. Every net that would be is asked whether it swings.
  /// \return the error that counts: beyond the tolerance where a surface that holds it at the points swings between them
  double offer(const FitProblem& problem, double error, bool least_squares = true);
  bool holds(double error) const { return error <= options_.tolerance.value; }
  /// A size is done with: listed in the result.
  void list(Index functions_u, Index functions_v, double error);

  /// Stopped, out of time or out of fits; the status says which.
  bool interrupted();
  /// Stopped or out of time; cheap, for inner loops.
  bool stopped() const;
  Control time_left() const { return knotfit::time_left(control_, start_); }
  Status interruption() const { return interruption_; }
  void set_stage(std::string_view stage) { stage_ = stage; }

  /// The caller's limit counts, not the default; one beyond the number of points limits nothing.
  bool own_limit() const {
    return options_.max_control_points > 0 && options_.max_control_points <= data_.points().size();
  }
  const Tolerance& tolerance() const { return options_.tolerance; }
  double span_ratio() const { return options_.span_ratio; }  ///< 0: not given
  /// Within the limit on control points, and what the data's own lines can tell apart.
  bool allowed(Index functions_u, Index functions_v) const;

  /// Best: the fewest control points that hold, else the least error among surfaces that keep to the data.
  RefineResult finish(Status unmet) const;
  bool reached() const { return best_holds_; }
  /// Some surface held the tolerance at the points and was refused for its swings.
  bool any_refused() const { return held_but_swings_; }
  const InteriorKnots& best() const { return best_; }

 private:
  /// A least-squares surface that holds at the points and swings at single places, held there by points of the data's own
  /// range. \return false where that does not end the swings or costs the tolerance; else surface, report and error are anew
  bool mend(const FitProblem& problem, const verify::SwingSites::Strays& strays, Surface& surface,
            SwingReport& report, double& error);
  const FitProblem& data_;
  const RefineOptions& options_;
  const Control& control_;
  long max_fits_;
  Index max_control_points_;
  std::vector<const FitProblem*> problems_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::string_view stage_;
  Status interruption_ = Status::not_run;
  InteriorKnots best_;
  Surface surface_;
  bool best_holds_ = false, best_swings_ = true, least_squares_ = true;
  bool held_but_swings_ = false;  ///< some surface held the tolerance at the points and was refused
  double best_error_;             ///< what counts against others
  double best_measured_ = 0;      ///< at the points
  InteriorKnots nearest_;         ///< of the least error at the points, whether the surface swings or not
  double nearest_error_ = std::numeric_limits<double>::infinity();
  Index best_size_ = 0;
  int mends_ = 0, wild_ = 0;
  long mend_fits_ = 0;
  std::vector<SizeTried> tried_;
};

/// Of two results the better, with the fits and sizes of both: the one that reached with fewer control points, else one that
/// does not swing, else the least error. A stop of either stays the status, and a time limit that cut the first short, or a further route
/// where neither holds. \param a  of the search itself
RefineResult better_of(RefineResult a, RefineResult b);

/// The control of a further route: its progress shows the best of an earlier one while that is better.
Control after(const RefineResult& earlier, const Control& control);

/// Default limit on control points: half the points; for scattered data at most 50 000, since their
/// band matrix grows with the power 3/2.
Index default_control_points(const FitProblem& data);

/// The residual's RMS only follows the noise: two sizes in a row gain no more than control points
/// gain on white noise, near the noise level found in the data [METHOD 4.8].
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
