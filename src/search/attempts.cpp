#include "search/attempts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/moving_fit.h"
#include "search/routes.h"
#include "verify/swing_limits.h"
namespace knotfit {

namespace {

/// The error that counts for a surface that holds at the points and swings between them: the tolerance times the root of how
/// far the swing is beyond what is allowed, and never so much that the size looks hopeless.
double refused(const SwingReport& swings, double tolerance) {
  return tolerance * std::clamp(std::sqrt(swings.largest / verify::kLargestSwing), 1.001, 1.3);
}

constexpr int kMostMends = 40, kMendRounds = 4;
// A net that swings by so many times what is allowed is wild; so many wild nets show that least squares alone will not do.
constexpr double kWild = 10;
constexpr int kMostWild = 2;

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
      run_(control, options.tolerance, options.max_fits > 0 ? options.max_fits : max_fits),
      max_control_points_(own_limit() ? options.max_control_points : default_control_points(data)),
      best_error_(std::numeric_limits<double>::infinity()) {
  count(data);
}

long Attempts::fits() const {
  long sum = mend_fits_;
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
  return offer(problem, problem.measured(options_.tolerance));
}

double Attempts::offer(const FitProblem& problem, double error, bool least_squares) {
  const Index size = problem.control_points();
  const auto smaller = [&] {
    return !best_holds_ || size < best_size_ || (size == best_size_ && error < best_error_);
  };
  const FitProblem* counts = &problem;
  if (whole_ && (holds(error) ? smaller() : !best_holds_)) {
    counts = &counted(problem);
    error = std::max(error, counts->measured(options_.tolerance));
  }
  const double measured = error;
  if (measured < nearest_error_) {
    nearest_error_ = measured;
    nearest_ = problem.knots();
  }
  bool good = holds(error);
  if (good ? smaller() : !best_holds_ && (best_swings_ || error < best_error_) && std::isfinite(error)) {
    Surface surface = problem.surface();
    verify::SwingSites::Strays strays;
    SwingReport report =
        options_.sites->measure(surface, counts->errors(), options_.tolerance.value, &strays);
    if (report.largest > kWild * verify::kLargestSwing) ++wild_;
    if (good && report.swings) {
      held_but_swings_ = true;
      if (least_squares && options_.energy && mend(problem, strays, surface, report, error)) {
        least_squares = false;
      } else {
        good = false;
        error = refused(report, options_.tolerance.value);
      }
    }
    // Among surfaces that swing, the error counts times the swing.
    const double counted =
        error * (report.swings ? std::max(1.0, report.largest / verify::kLargestSwing) : 1);
    if (good || (!best_holds_ && (report.swings != best_swings_ ? !report.swings : counted < best_error_))) {
      best_ = problem.knots();
      surface_ = std::move(surface);
      best_holds_ = good;
      best_swings_ = report.swings;
      best_error_ = counted;
      best_measured_ = good ? error : measured;
      best_size_ = size;
      least_squares_ = least_squares;
    }
  } else if (surface_.empty()) {  // nothing else yet
    best_ = problem.knots();
  }
  BestShown shown;
  if (!surface_.empty())
    shown = {best_measured_, static_cast<int>(surface_.size_u()), static_cast<int>(surface_.size_v())};
  run_.show(shown, fits());
  return error;
}

bool Attempts::mend(const FitProblem& problem, const verify::SwingSites::Strays& first, Surface& surface,
                    SwingReport& report, double& error) {
  if (mends_ == kMostMends) return false;
  ++mends_;
  verify::SwingSites::Strays strays = first;
  JoinedPoints joined(problem.points());
  for (int round = 0; round < kMendRounds && !strays.uv.empty() && !stopped(); ++round) {
    for (std::size_t k = 0; 2 * k < strays.uv.size(); ++k)
      joined.join(strays.uv[2 * k], strays.uv[2 * k + 1],
                  strays.values.data() + k * static_cast<std::size_t>(problem.points().dimension), 1, 1);
    MovingFit held(joined.points(), problem.degree_u(), problem.degree_v(), search_fits(options_));
    held.count_first(problem.counted());
    ++mend_fits_;
    if (!held.solve(problem.knots())) return false;
    const FitProblem& counts = counted(held);
    const double measured = std::max(held.measured(options_.tolerance), counts.measured(options_.tolerance));
    if (!holds(measured)) return false;
    strays = {};
    const SwingReport again =
        options_.sites->measure(held.surface(), counts.errors(), options_.tolerance.value, &strays);
    if (again.swings) continue;
    surface = held.surface();
    report = again;
    error = measured;
    return true;
  }
  return false;
}

bool Attempts::interrupted() {
  if (interruption_ != Status::not_run) return true;
  if (stopped())
    interruption_ = run_.cut_or(Status::not_run);
  else if ((held_but_swings_ || wild_ >= kMostWild) &&
           !options_.energy)  // it begins anew with the data energy
    interruption_ = held_but_swings_ ? Status::swings : Status::not_reached;
  else if (run_.interrupted(fits()))
    interruption_ = Status::limit_reached;
  return interruption_ != Status::not_run;
}

RefineResult Attempts::finish(Status unmet) const {
  RefineResult result;
  // Running out of fits while walking down is the search's normal end; being stopped is not.
  const bool cut = interruption_ == Status::stopped || interruption_ == Status::time_limit;
  result.status = cut                                ? interruption_
                  : best_holds_                      ? Status::reached
                  : held_but_swings_                 ? Status::swings
                  : interruption_ != Status::not_run ? interruption_
                                                     : unmet;
  result.knots = best_;
  result.surface = surface_;
  result.least_squares = least_squares_;
  result.swings = best_swings_;
  result.nearest = nearest_;
  result.holds = best_holds_;
  result.error = best_measured_;
  result.fits = fits();
  result.tried = run_.tried();
  return result;
}

}  // namespace knotfit
