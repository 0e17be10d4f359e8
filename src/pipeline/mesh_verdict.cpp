#include "pipeline/mesh_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/message.h"
#include "pipeline/request.h"
#include "pipeline/verdict.h"
namespace knotfit {
namespace {

/// The error that the tolerance is of, of the surface's distances to the mesh; a share between those that are known by the
/// next larger one.
double measured_back(const DistanceSummary& back, const Tolerance& asked) {
  if (asked.measure == ErrorMeasure::rms) return back.rms;
  if (asked.measure == ErrorMeasure::max || asked.share > 0.995) return back.max;
  return asked.share > 0.99 ? back.p995 : asked.share > 0.95 ? back.p99 : back.p95;
}

/// First of the notes: a surface that strays from the mesh between the vertices.
void note_straying(const MeshFit& fit, std::vector<std::string>& notes) {
  if (fit.to_mesh.count == 0 || !(fit.result.tolerance > 0)) return;
  const double back = measured_back(fit.to_mesh, fit.result.asked);
  if (!(back > 2 * fit.result.tolerance)) return;
  const double* p = fit.to_mesh.worst_point;
  notes.insert(
      notes.begin(),
      fmt::format(
          "between the vertices the surface strays from the mesh by {:.3g}, {:.3g} tolerances (largest "
          "distance {:.3g} at u = {:.4g}, v = {:.4g}, near ({:.8g}, {:.8g}, {:.8g})): more vertices "
          "there, or more control points, hold it",
          back, back / fit.result.tolerance, fit.to_mesh.max, fit.to_mesh.worst_u, fit.to_mesh.worst_v, p[0],
          p[1], p[2]));
}

/// What a user should know of the corrected surface.
void add_notes(MeshFit& fit) {
  const FoldReport& folds = fit.correction.folds;
  std::vector<std::string>& notes = fit.result.notes;
  if (folds_over(folds)) {
    // The number that decided.
    std::string note =
        folds.blurred > kMostBlurredFold
            ? fmt::format("the surface folds over {:.2g} % of the square", 100 * folds.blurred)
            : fmt::format("the surface folds in pleats narrower than a span over {:.2g} % of the square",
                          100 * folds.pleats);
    if (!folds.places.empty())
      note += fmt::format(", most at u = {:.4g}, v = {:.4g}", folds.places[0].u, folds.places[0].v);
    notes.push_back(note + ": more control points, or a looser tolerance, leave less of it");
  }
  if (folds.flipped > 0)
    notes.push_back(fmt::format("{} parameter triangles are turned over or flat", folds.flipped));
  if (fit.to_mesh.count > 0 && fit.to_mesh.rms > 2 * fit.correction.distance.rms)
    notes.push_back(fmt::format(
        "between the vertices the surface is farther from the mesh (RMS {:.3g}, max {:.3g}) than the "
        "vertices are from it: the facets are coarse for this surface",
        fit.to_mesh.rms, fit.to_mesh.max));
  if (fit.off_foot > 0)
    notes.push_back(
        fmt::format("{} point{} not at the foot points, where triangles would turn over: up to {:.3g} off at "
                    "the parameters; errors "
                    "are distances all the same",
                    fit.off_foot, fit.off_foot == 1 ? " is" : "s are", fit.off_foot_error));
  if (fit.correction.status == CorrectionStatus::no_gain)
    notes.push_back("no round of the correction came nearer than the plain fit, which is kept");
  note_straying(fit, notes);
}

}  // namespace

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
  sound = sound && r.recheck_difference <= 1e-10 * r.diagonal + 64 * 2.3e-16 * r.surface.scale();
  if (!sound) {
    r.status = Status::failed;
    r.message = fmt::format(
        "the surface failed its own check: distances measured apart from the correction differ by {:.3g}",
        r.recheck_difference);
  }
  return sound;
}

bool holds_tolerance(const MeshFit& fit) {
  const FitResult& r = fit.result;
  return r.tolerance > 0 && measured_error(r.errors, r.asked) <= r.tolerance;
}

void give_verdict(MeshFit& fit, const FitOptions& options) {
  FitResult& r = fit.result;
  r.least_squares = false;
  r.condition = 0;
  r.against_uniform = r.against_error_model = {};  // they compare errors at the parameters
  r.measured = options.tolerance ? measured_error(r.errors, r.asked) : r.error.max;
  const bool holds = holds_tolerance(fit), folded = folds_over(fit.correction.folds);
  r.reached = holds && !folded;
  r.status =
      status_of({r.status, !has_size_or_knots(options), options.tolerance.has_value(), holds, false, folded});
  add_notes(fit);
  r.message = message_of(r, fit.points.size());
}

}  // namespace knotfit
