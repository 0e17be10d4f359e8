#include "refine/attempts.h"

#include <algorithm>
#include <cmath>
#include <limits>
namespace knotfit {

namespace {

/// Low and high of each component, enlarged by the diagonal on either side.
std::vector<double> enlarged_box(const ParameterizedPoints& points) {
  const int d = points.dimension;
  std::vector<double> box(2 * d);
  const double diagonal = bounding_diagonal(points);
  for (int e = 0; e < d; ++e) {
    double low = INFINITY, high = -INFINITY;
    for (Index k = 0; k < points.size(); ++k) {
      low = std::min(low, points.value(k)[e]);
      high = std::max(high, points.value(k)[e]);
    }
    box[2 * e] = low - diagonal;
    box[2 * e + 1] = high + diagonal;
  }
  return box;
}

bool keeps_to(const std::vector<double>& box, const std::vector<double>& net) {
  const std::size_t d = box.size() / 2;
  for (std::size_t i = 0; i < net.size(); ++i)
    if (!(net[i] >= box[2 * (i % d)] && net[i] <= box[2 * (i % d) + 1])) return false;
  return true;
}

}  // namespace

Index default_control_points(const FitProblem& data) {
  const Index minimum = Index{data.degree_u() + 1} * (data.degree_v() + 1);
  Index most = data.points().size() / 2;
  if (!data.on_grid()) most = std::min<Index>(most, 50000);
  return std::max(most, minimum);
}

Attempts::Attempts(const FitProblem& data, const RefineOptions& options, const Control& control,
                   long max_fits)
    : data_(data),
      options_(options),
      control_(control),
      max_fits_(options.max_fits > 0 ? options.max_fits : max_fits),
      max_control_points_(own_limit() ? options.max_control_points : default_control_points(data)),
      box_(enlarged_box(data.points())),
      best_error_(std::numeric_limits<double>::infinity()) {
  count(data);
}

long Attempts::fits() const {
  long sum = 0;
  for (const FitProblem* problem : problems_) sum += problem->fits();
  return sum;
}

bool Attempts::allowed(Index functions_u, Index functions_v) const {
  // One patch is allowed on fewer grid lines than it has functions, too: the smoothing floor holds it.
  return functions_u <= std::max<Index>(data_.most_functions_u(), data_.degree_u() + 1) &&
         functions_v <= std::max<Index>(data_.most_functions_v(), data_.degree_v() + 1) &&
         functions_u * functions_v <= max_control_points_;
}

double Attempts::fit(FitProblem& problem, const InteriorKnots& knots) {
  problem.solve(knots);
  const double error = problem.measured(options_.tolerance);
  offer(problem, error);
  return error;
}

void Attempts::offer(const FitProblem& problem, double error, bool least_squares) {
  const Index size = problem.control_points();
  const bool good = holds(error);
  // A net far outside the data swings between the points: the last choice where none holds.
  const bool tame = keeps_to(box_, problem.net());
  const bool better = good
                          ? (!best_holds_ || size < best_size_ || (size == best_size_ && error < best_error_))
                          : (!best_holds_ && (tame != best_tame_ ? tame : error < best_error_));
  if (better) {
    best_ = problem.knots();
    surface_ = problem.surface();
    best_holds_ = good;
    best_tame_ = tame;
    best_error_ = error;
    best_size_ = size;
    least_squares_ = least_squares;
  }
  if (!control_.progress) return;
  Progress progress;
  progress.stage = stage_;
  progress.error = best_error_;
  progress.tolerance = options_.tolerance.value;
  progress.size_u = static_cast<int>(problem.axis_u().functions());
  progress.size_v = static_cast<int>(problem.axis_v().functions());
  progress.fits = fits();
  control_.progress(progress);
}

void Attempts::list(Index functions_u, Index functions_v, double error) {
  tried_.push_back({static_cast<int>(functions_u), static_cast<int>(functions_v), error, holds(error)});
}

bool Attempts::stopped() const {
  return control_.stop.stop_requested() || out_of_time(control_, start_);
}

bool Attempts::interrupted() {
  if (interruption_ != Status::not_run) return true;
  if (stopped())
    interruption_ = control_.stop.stop_requested() ? Status::stopped : Status::time_limit;
  else if (fits() >= max_fits_)
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
  result.surface = surface_;
  result.least_squares = least_squares_;
  result.error = best_error_;
  result.fits = fits();
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
