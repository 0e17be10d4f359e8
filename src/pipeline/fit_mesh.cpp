#include "knotfit/fit_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/deadline.h"
#include "fit/error_measure.h"
#include "pipeline/distances.h"
#include "pipeline/message.h"
#include "pipeline/request.h"
#include "pipeline/verdict.h"
#include "search/mesh_search.h"
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

/// The distances of the vertices that are data. \return false where the check fails
bool take_vertex_distances(MeshFit& fit, const Mesh& mesh) {
  const CorrectionResult& c = fit.correction;
  fit.result.surface = c.surface;
  std::vector<double> distances, feet;
  for (Index k = 0; k < mesh.vertex_count(); ++k) {
    if (std::isnan(c.signed_distances[k])) continue;
    distances.push_back(c.signed_distances[k]);
    feet.insert(feet.end(), {c.foot_points[2 * k], c.foot_points[2 * k + 1]});
  }
  return take_distances(fit, mesh_points(mesh, c.uv), std::move(distances), std::move(feet));
}

/// The correction of knots that a method placed at the map's parameters. \return false: the plain fit is kept
bool correct_placed(MeshFit& fit, const Mesh& mesh, const MeshMap& map, const FitOptions& options,
                    const CorrectionOptions& how, const Control& control) {
  const Deadline deadline(control);
  FitOptions plain = options;
  plain.between = false;
  fit.result = fit_surface(mesh_points(mesh, map.uv), plain, control);
  fit.points = mesh_points(mesh, map.uv);
  const FitResult& r = fit.result;
  if (r.surface.empty() || r.status == Status::failed) return false;
  fit.correction =
      correct_parameters(mesh, map, r.surface.knots_u(), r.surface.knots_v(), how, deadline.left());
  return true;
}

/// A size searched with the correction inside, or a fixed one whose knots move with the parameters.
void search(MeshFit& fit, const Mesh& mesh, const MeshMap& map, const FitOptions& options,
            const CorrectionOptions& given, const Control& control) {
  fit.points = mesh_points(mesh, map.uv);
  check_requirements(fit.points, options);
  FitResult& r = fit.result;
  r.map = fit.points.map;
  r.effort = options.effort;
  r.smoothing = options.smoothing;
  CorrectionOptions how = given;
  if (how.aspect == 0) how.aspect = map.quality.aspect;
  how.data_vertices = mesh.vertex_count();
  const Mesh halved = halve_edges(mesh, map.halved_edges);
  const correction::PreparedMesh prepared(halved, map.all_uv(), how);
  Request request = make_request(options.tolerance, has_size_or_knots(options), fit.points,
                                 Frame(fit.points).rounding(), prepared.frame().scale());
  r.diagonal = request.diagonal;
  r.asked = request.asked;
  r.tolerance = request.asked.value;
  if (!request.with_tolerance()) request.inside.measure = ErrorMeasure::rms;
  MeshSearch found = request.searched ? search_mesh_sizes(prepared, options, request.inside, control)
                                      : fit_mesh_size(prepared, options, options.control_points_u,
                                                      options.control_points_v, request.inside, control);
  r.status = found.status;
  r.tried = std::move(found.tried);
  r.method = found.method;
  r.fits = found.fits;
  fit.correction = std::move(found.correction);
  correction::keep_first(mesh.vertex_count(), fit.correction);
}

}  // namespace

MeshFit fit_mesh(const Mesh& mesh, const MeshMap& map, const FitOptions& options,
                 const CorrectionOptions& correction, const Control& control) {
  MeshFit fit;
  CorrectionOptions how = correction;
  how.smoothing = options.smoothing;
  if (options.tolerance) {
    how.keep_by.measure = options.tolerance->measure;
    how.keep_by.share = options.tolerance->share;
    if (row_of(options.tolerance->measure).every_point && correction.reweighting == 0.1)
      how.reweighting = 1;  // the maximum counts
  }
  FitResult& r = fit.result;
  const bool searched = !has_size_or_knots(options);
  const bool moves = !options.knots && options.control_points_v > 0 &&
                     placement_method(options.method).traits.on_mesh != MeshKnots::placed_once;
  if (searched || moves)
    search(fit, mesh, map, options, how, control);
  else if (!correct_placed(fit, mesh, map, options, how, control))
    return fit;
  if (fit.correction.status == CorrectionStatus::singular) {
    r.notes.push_back("the control points of the correction could not be solved for: the plain fit is kept");
    return fit;
  }
  if (!take_vertex_distances(fit, mesh)) {
    r.status = Status::failed;
    r.message = failed_check(r);
    return fit;
  }
  r.least_squares = false;
  r.condition = 0;
  r.against_uniform = r.against_error_model = {};  // they compare errors at the parameters
  r.measured = options.tolerance ? measured_error(r.errors, r.asked) : r.error.max;
  const bool holds = options.tolerance && r.measured <= r.tolerance;
  const bool folded = folds_over(fit.correction.folds);
  r.reached = holds && !folded;
  if (fit.correction.status == CorrectionStatus::stopped)
    r.status = control.stop.stop_requested() ? Status::stopped : Status::time_limit;
  r.status = status_of({r.status, searched, options.tolerance.has_value(), holds, false, folded});
  if (!searched && !moves) r.fits += static_cast<long>(fit.correction.rounds.size());
  if (!control.stop.stop_requested()) fit.to_mesh = mesh_distances(r.surface, mesh, fit.correction.uv, 300);
  add_notes(fit);
  r.message = message_of(r, fit.points.size());
  return fit;
}

}  // namespace knotfit
