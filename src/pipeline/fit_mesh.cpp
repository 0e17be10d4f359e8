#include "knotfit/fit_mesh.h"

#include "pipeline/corrected_fit.h"
#include "pipeline/mesh_verdict.h"
namespace knotfit {

MeshFit fit_mesh(const Mesh& mesh, const MeshMap& map, const FitOptions& options,
                 const CorrectionOptions& correction, const Control& control) {
  CorrectedFit found = corrected_fit(mesh, map, options, correction, control);
  if (!found.corrected) return std::move(found.fit);
  if (!control.stop.stop_requested())
    found.fit.to_mesh = mesh_distances(found.fit.result.surface, mesh, found.fit.correction.uv, 300);
  give_verdict(found.fit, options);
  return std::move(found.fit);
}

}  // namespace knotfit
