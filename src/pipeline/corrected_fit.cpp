#include "pipeline/corrected_fit.h"

#include <cmath>

#include "base/deadline.h"
#include "fit/error_measure.h"
#include "pipeline/mesh_verdict.h"
#include "pipeline/request.h"
#include "search/mesh_search.h"
namespace knotfit {
namespace {

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

CorrectedFit corrected_fit(const Mesh& mesh, const MeshMap& map, const FitOptions& options,
                           const CorrectionOptions& correction, const Control& control) {
  CorrectedFit out;
  MeshFit& fit = out.fit;
  CorrectionOptions how = correction;
  how.smoothing = options.smoothing;
  if (options.tolerance) {
    how.keep_by.measure = options.tolerance->measure;
    how.keep_by.share = options.tolerance->share;
    if (row_of(options.tolerance->measure).every_point && correction.reweighting == 0.1)
      how.reweighting = 1;  // the maximum counts
  }
  const bool moves = !options.knots && options.control_points_v > 0 &&
                     placement_method(options.method).traits.on_mesh != MeshKnots::placed_once;
  if (!has_size_or_knots(options) || moves)
    search(fit, mesh, map, options, how, control);
  else if (!correct_placed(fit, mesh, map, options, how, control))
    return out;
  FitResult& r = fit.result;
  if (fit.correction.status == CorrectionStatus::singular) {
    r.notes.push_back("the control points of the correction could not be solved for: the plain fit is kept");
    return out;
  }
  if (has_size_or_knots(options) && !moves) r.fits += static_cast<long>(fit.correction.rounds.size());
  if (fit.correction.status == CorrectionStatus::stopped)
    r.status = control.stop.stop_requested() ? Status::stopped : Status::time_limit;
  out.corrected = take_vertex_distances(fit, mesh);
  return out;
}

}  // namespace knotfit
