// The best surface so far of a search, and the verdict on every one that would be it.
#pragma once
#include <algorithm>
#include <limits>

#include "fit/fit_problem.h"
#include "search/search_run.h"
#include "search/whole_data.h"
#include "verify/swings.h"
namespace knotfit {

class Attempts {
 public:
  /// \param data  the points themselves: their number and grid lines limit the sizes
  Attempts(const FitProblem& data, const RefineOptions& options, const Control& control, long max_fits);

  /// Where problems are over a sample: surfaces are measured over all points before they are kept.
  void measure_over(WholeData* whole) { whole_ = whole; }
  /// Another problem whose fits count.
  void count(const FitProblem& problem) { problems_.push_back(&problem); }
  long fits() const;

  /// Fits on these knots and offers the result. \return the error that counts
  double fit(FitProblem& problem, const InteriorKnots& knots);
  /// Measures whether the surface that the problem holds swings, where it would be the best so far, and keeps the better one.
  /// \return the error that counts; a surface that holds at the points and swings between them counts as beyond the tolerance
  double offer(const FitProblem& problem, double error, bool least_squares = true);
  bool holds(double error) const { return run_.holds(error); }
  /// A size is done with: listed in the result.
  void list(Index functions_u, Index functions_v, double error) {
    run_.list(functions_u, functions_v, error, holds(error));
  }

  /// Stopped, out of time or out of fits; the status says which.
  bool interrupted();
  /// Stopped or out of time; cheap, for inner loops.
  bool stopped() const { return run_.stopped(); }
  Control time_left() const { return run_.time_left(); }
  Status interruption() const { return interruption_; }
  void set_stage(std::string_view stage) { run_.set_stage(stage); }

  /// Whether the caller gave a limit. One beyond the number of points limits nothing.
  bool own_limit() const {
    return options_.max_control_points > 0 && options_.max_control_points <= data_.points().size();
  }
  /// No size goes beyond it, whatever the caller's limit.
  void limit_control_points(Index most) { max_control_points_ = std::min(max_control_points_, most); }
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
  /// Adds points of the data's own range at the single places where a least-squares surface swings, and fits again.
  /// \return whether that ends the swings and keeps the tolerance; then surface, report and error are the new ones
  bool mend(const FitProblem& problem, const verify::SwingSites::Strays& strays, Surface& surface,
            SwingReport& report, double& error);
  const FitProblem& data_;
  const RefineOptions& options_;
  /// The problem whose errors count for the surface that this one holds.
  const FitProblem& counted(const FitProblem& problem) const {
    return whole_ ? whole_->measure(problem) : problem;
  }

  SearchRun run_;
  WholeData* whole_ = nullptr;
  Index max_control_points_;
  std::vector<const FitProblem*> problems_;
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
};

/// Default limit on control points: half the points; for scattered data at most 50 000, since their
/// band matrix grows with the power 3/2.
Index default_control_points(const FitProblem& data);

}  // namespace knotfit
