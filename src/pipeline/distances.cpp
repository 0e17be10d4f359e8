#include "pipeline/distances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
namespace knotfit {

bool take_distances(MeshFit& fit, ParameterizedPoints points, std::vector<double> signed_distances,
                    std::vector<double> feet) {
  FitResult& r = fit.result;
  fit.points = std::move(points);
  fit.signed_distances = std::move(signed_distances);
  fit.foot_uv = std::move(feet);
  ParameterizedPoints at_feet = fit.points;
  at_feet.uv = fit.foot_uv;
  r.errors.clear();
  for (const double d : fit.signed_distances) r.errors.push_back(std::abs(d));
  r.error = summarize_errors(r.errors, at_feet);
  const std::vector<double> at_parameters = recheck_errors(r.surface, fit.points);
  fit.at_parameters = summarize_errors(at_parameters, fit.points);
  fit.off_foot = 0;
  fit.off_foot_error = 0;
  const double beyond = r.tolerance > 0 ? r.tolerance : r.error.max;
  for (std::size_t k = 0; k < at_parameters.size(); ++k)
    if (at_parameters[k] > std::max(beyond, 2 * r.errors[k])) {
      ++fit.off_foot;
      fit.off_foot_error = std::max(fit.off_foot_error, at_parameters[k]);
    }
  const std::vector<double> rechecked = recheck_errors(r.surface, at_feet);
  r.recheck_difference = 0;
  bool sound = true;
  for (std::size_t k = 0; k < rechecked.size(); ++k) {
    sound = sound && std::isfinite(rechecked[k]);
    r.recheck_difference = std::max(r.recheck_difference, std::abs(rechecked[k] - r.errors[k]));
  }
  return sound && r.recheck_difference <= 1e-10 * r.diagonal + 64 * 2.3e-16 * r.surface.scale();
}

std::string failed_check(const FitResult& result) {
  return fmt::format(
      "the surface failed its own check: distances measured apart from the correction differ by {:.3g}",
      result.recheck_difference);
}

}  // namespace knotfit
