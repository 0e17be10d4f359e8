#include "knotfit/correct.h"

#include <fmt/format.h>

#include "correct/prepared_mesh.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

void check_knots(const KnotVector& knots, const char* name) {
  if (!knots.is_clamped() || knots.first() != 0 || knots.last() != 1)
    throw InvalidInput(fmt::format("the knots in {} must be clamped on [0,1] for a correction", name));
}

}  // namespace

CorrectionResult correct_parameters(const Mesh& mesh, const std::vector<double>& uv,
                                    const KnotVector& knots_u, const KnotVector& knots_v,
                                    const CorrectionOptions& given, const Control& control) {
  check_knots(knots_u, "u");
  check_knots(knots_v, "v");
  if (given.start && (given.start->dimension() != 3 || given.start->knots_u() != knots_u ||
                      given.start->knots_v() != knots_v))
    throw InvalidInput("the surface to start from is over other knots");
  const correction::PreparedMesh prepared(mesh, uv, given);
  CorrectionOptions options = prepared.options();
  if (options.start) options.start = prepared.frame().inside(*options.start);
  options.keep_by.value /= prepared.frame().scale();
  const Stage stage(control, "correction");
  return prepared.finish(prepared.run(uv, knots_u, knots_v, options, stage), !options.start, control);
}

CorrectionResult correct_parameters(const Mesh& mesh, const MeshMap& map, const KnotVector& knots_u,
                                    const KnotVector& knots_v, const CorrectionOptions& given,
                                    const Control& control) {
  CorrectionOptions options = given;
  if (options.aspect == 0) options.aspect = map.quality.aspect;
  if (options.data_vertices < 0) options.data_vertices = mesh.vertex_count();
  CorrectionResult result = correct_parameters(halve_edges(mesh, map.halved_edges), map.all_uv(), knots_u,
                                               knots_v, options, control);
  correction::keep_first(mesh.vertex_count(), result);
  return result;
}

}  // namespace knotfit
