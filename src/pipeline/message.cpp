#include "pipeline/message.h"

#include <fmt/format.h>
namespace knotfit {
namespace {

std::string measure_name(const Tolerance& t) {
  switch (t.measure) {
    case ErrorMeasure::max:
      return "largest error";
    case ErrorMeasure::rms:
      return "RMS error";
    case ErrorMeasure::percentile:
      break;
  }
  return fmt::format("error of {:g} % of the points", 100 * t.share);
}

}  // namespace

namespace {

std::string sentence_of(const FitResult& r, Index points) {
  const std::string size = fmt::format("{} x {} = {} control points", r.surface.size_u(), r.surface.size_v(),
                                       r.surface.control_point_count());
  const std::string measured =
      r.tolerance > 0
          ? fmt::format("{} {:.4g}, tolerance {:.4g}", measure_name(r.asked), r.measured, r.tolerance)
          : fmt::format("RMS error {:.4g}, largest {:.4g}", r.error.rms, r.error.max);
  switch (r.status) {
    case Status::reached:
      return fmt::format("{} hold the tolerance: {}", size, measured);
    case Status::fixed_size:
      return fmt::format("{}: {}", size, measured);
    case Status::not_reached:
      return fmt::format("{} do not hold the tolerance: {}", size, measured);
    case Status::data_too_sparse:
      return fmt::format(
          "the {} points are too sparse for this tolerance: no size within the limit of control points that "
          "such data supports holds it; best {}: {}",
          points, size, measured);
    case Status::tolerance_below_noise:
      return fmt::format(
          "the tolerance is below the noise of the data (standard deviation about {:.3g}): more control "
          "points would only follow the noise; best {}: {}",
          r.noise, size, measured);
    case Status::swings:
      return r.measured <= r.tolerance
                 ? fmt::format(
                       "the tolerance holds at the points, but between them the surface swings; {}: {}", size,
                       measured)
                 : fmt::format(
                       "every surface found that holds the tolerance at the points swings between them; the "
                       "best "
                       "that does not, {}: {}",
                       size, measured);
    case Status::folded:
      return fmt::format(
          "the surface folds over the mesh, though at the vertices the tolerance holds; {}: {}", size,
          measured);
    case Status::limit_reached:
      return fmt::format("the limit on control points or fits was reached; best {}: {}", size, measured);
    case Status::time_limit:
      return fmt::format("the time limit cut the search short; {} {}: {}", r.reached ? "so far" : "best",
                         size, measured);
    case Status::stopped:
      return fmt::format("stopped; {} {}: {}", r.reached ? "so far" : "best", size, measured);
    case Status::failed:
      return fmt::format("the fit failed its own check; {}: {}", size, measured);
    case Status::not_run:
      break;
  }
  return "nothing was fitted";
}

}  // namespace

std::string message_of(const FitResult& r, Index points) {
  std::string message = sentence_of(r, points);
  if (r.left_out > 0)
    message += fmt::format(
        "; {} points of the input were merged or left out, and of all its points the farthest is {:.4g} off",
        r.left_out, r.all_max);
  return message;
}

}  // namespace knotfit
