#include "pipeline/message.h"

#include <fmt/format.h>

#include "fit/error_measure.h"
namespace knotfit {
namespace {

/// What a sentence needs of a result.
struct Told {
  Status status;
  std::string_view what;  ///< "surface" or "curve"
  std::string size;       ///< "12 x 9 = 108 control points"
  std::string measured;   ///< "largest error 0.01, tolerance 0.02"
  Index points = 0;
  double noise = 0;
  bool reached = false, at_points = false;  ///< the tolerance holds; at the points at least
};

std::string measured_text(double measured, double tolerance, const Tolerance& asked,
                          const ErrorSummary& error) {
  return tolerance > 0 ? fmt::format("{} {:.4g}, tolerance {:.4g}", words_of(asked), measured, tolerance)
                       : fmt::format("RMS error {:.4g}, largest {:.4g}", error.rms, error.max);
}

std::string sentence_of(const Told& r) {
  const std::string best = fmt::format("best {}: {}", r.size, r.measured);
  const std::string so_far = fmt::format("{} {}: {}", r.reached ? "so far" : "best", r.size, r.measured);
  switch (r.status) {
    case Status::reached:
      return fmt::format("{} hold the tolerance: {}", r.size, r.measured);
    case Status::fixed_size:
      return fmt::format("{}: {}", r.size, r.measured);
    case Status::not_reached:
      return fmt::format("{} do not hold the tolerance: {}", r.size, r.measured);
    case Status::data_too_sparse:
      return fmt::format(
          "the {} points are too sparse for this tolerance: no size within the limit of control points that "
          "such data supports holds it; {}",
          r.points, best);
    case Status::tolerance_below_noise:
      return fmt::format(
          "the tolerance is below the noise of the data (standard deviation about {:.3g}): more control "
          "points would only follow the noise; {}",
          r.noise, best);
    case Status::swings:
      return r.at_points
                 ? fmt::format("the tolerance holds at the points, but between them the {} swings; {}: {}",
                               r.what, r.size, r.measured)
                 : fmt::format(
                       "every {} found that holds the tolerance at the points swings between them; "
                       "the best that does not, {}: {}",
                       r.what, r.size, r.measured);
    case Status::folded:
      return fmt::format("the {} folds over the mesh, though at the vertices the tolerance holds; {}: {}",
                         r.what, r.size, r.measured);
    case Status::limit_reached:
      return "the limit on control points or fits was reached; " + best;
    case Status::time_limit:
      return "the time limit cut the search short; " + so_far;
    case Status::stopped:
      return "stopped; " + so_far;
    case Status::failed:
      return fmt::format("the fit failed its own check; {}: {}", r.size, r.measured);
    case Status::not_run:
      break;
  }
  return "nothing was fitted";
}

}  // namespace

std::string message_of(const FitResult& r, Index points) {
  std::string message = sentence_of({r.status, "surface",
                                     fmt::format("{} x {} = {} control points", r.surface.size_u(),
                                                 r.surface.size_v(), r.surface.control_point_count()),
                                     measured_text(r.measured, r.tolerance, r.asked, r.error), points,
                                     r.noise, r.reached, r.measured <= r.tolerance});
  if (r.left_out > 0)
    message += fmt::format(
        "; {} points of the input were merged or left out, and of all its points the farthest is {:.4g} off",
        r.left_out, r.all_max);
  return message;
}

std::string message_of(const CurveFitResult& r, Index points) {
  if (r.status == Status::failed) return "no curve: the normal equations of these knots cannot be solved";
  return sentence_of({r.status, "curve", fmt::format("{} control points", r.control_points),
                      measured_text(r.measured, r.tolerance, r.asked, r.error), points, r.noise, r.reached,
                      r.measured <= r.tolerance});
}

}  // namespace knotfit
