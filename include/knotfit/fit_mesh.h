// The whole way for a mesh: knots, then parameters and control points together, then distances both ways.
#pragma once
#include "knotfit/correct.h"
#include "knotfit/fit_surface.h"
namespace knotfit {

struct MeshFit {
  FitResult result;  ///< its errors are distances to the surface
  CorrectionResult correction;
  ParameterizedPoints points;  ///< the data, at the corrected parameters; result.errors are in its order
  std::vector<double> signed_distances;  ///< of the points, by the surface's normal
  ErrorSummary at_parameters;            ///< |S - P| at the corrected parameters
  DistanceSummary to_mesh;  ///< of the surface to the mesh: waves and flaps away from the vertices
};

/// Places knots at a fixed size by fit_surface(), corrects the parameters on them, and judges by the distance:
/// tolerance, status and errors of the result are those of the corrected surface. Folds that are left, and a
/// surface that strays from the mesh, are among the notes.
/// \throws InvalidInput  see fit_surface(), correct_parameters(); neither a size nor knots are given
MeshFit fit_mesh(const Mesh& mesh, const MeshMap& map, const FitOptions& options,
                 const CorrectionOptions& correction = {}, const Control& control = {});

}  // namespace knotfit
