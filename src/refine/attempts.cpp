#include "refine/attempts.h"

#include <algorithm>
#include <cmath>
#include <limits>
namespace knotfit {

Index default_control_points(const FitProblem& problem) {
  const Index minimum = Index{problem.degree_u() + 1} * (problem.degree_v() + 1);
  Index most = problem.points().size() / 2;
  if (!problem.on_grid()) most = std::min<Index>(most, 50000);
  return std::max(most, minimum);
}

Attempts::Attempts(FitProblem& problem, const RefineOptions& options, const Control& control)
    : problem_(problem),
      options_(options),
      control_(control),
      max_control_points_(options.max_control_points > 0 ? options.max_control_points
                                                         : default_control_points(problem)),
      best_error_(std::numeric_limits<double>::infinity()) {}

bool Attempts::allowed(Index functions_u, Index functions_v) const {
  return functions_u <= problem_.most_functions_u() && functions_v <= problem_.most_functions_v() &&
         functions_u * functions_v <= max_control_points_;
}

double Attempts::fit(const InteriorKnots& knots) {
  problem_.solve(knots);
  return take();
}

double Attempts::take() {
  const double error = problem_.measured(options_.tolerance);
  const Index size = problem_.control_points();
  const bool good = holds(error);
  const bool better = good
                          ? (!best_holds_ || size < best_size_ || (size == best_size_ && error < best_error_))
                          : (!best_holds_ && (error < best_error_ || best_size_ == 0));
  if (better) {
    best_ = problem_.knots();
    best_holds_ = good;
    best_error_ = error;
    best_size_ = size;
  }
  report();
  return error;
}

void Attempts::report() {
  if (!control_.progress) return;
  Progress progress;
  progress.stage = stage_;
  progress.error = best_error_;
  progress.tolerance = options_.tolerance.value;
  progress.size_u = static_cast<int>(problem_.axis_u().functions());
  progress.size_v = static_cast<int>(problem_.axis_v().functions());
  progress.fits = problem_.fits();
  control_.progress(progress);
}

void Attempts::list(Index functions_u, Index functions_v, double error) {
  tried_.push_back({static_cast<int>(functions_u), static_cast<int>(functions_v), error, holds(error)});
}

bool Attempts::interrupted() {
  if (interruption_ != Status::not_run) return true;
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
  if (control_.stop.stop_requested())
    interruption_ = Status::stopped;
  else if (control_.time_limit > 0 && spent.count() > control_.time_limit)
    interruption_ = Status::time_limit;
  else if (problem_.fits() >= options_.max_fits)
    interruption_ = Status::limit_reached;
  return interruption_ != Status::not_run;
}

RefineResult Attempts::finish(Status unmet) const {
  RefineResult result;
  // Running out of fits while walking down is the search's normal end; being stopped is not.
  const bool cut = interruption_ == Status::stopped || interruption_ == Status::time_limit;
  result.status = cut                                ? interruption_
                  : best_holds_                      ? Status::reached
                  : interruption_ != Status::not_run ? interruption_
                                                     : unmet;
  result.knots = best_;
  result.error = best_error_;
  result.fits = problem_.fits();
  result.tried = tried_;
  return result;
}

NoisePlateau::NoisePlateau(double noise, Index points, int dimension)
    : level_(noise * std::sqrt(static_cast<double>(dimension))), points_(static_cast<double>(points)) {}

bool NoisePlateau::add(Index control_points, double rms) {
  const double size = static_cast<double>(control_points);
  // White noise of N points keeps a share (N - n)/N of its squares beside n control points.
  const bool flat = level_ > 0 && last_size_ > 0 && size > last_size_ && rms < 1.5 * level_ &&
                    rms > 0.97 * last_rms_ * std::sqrt((points_ - size) / (points_ - last_size_));
  flat_ = flat ? flat_ + 1 : 0;
  last_size_ = size;
  last_rms_ = rms;
  return flat_ >= 2;
}

}  // namespace knotfit
