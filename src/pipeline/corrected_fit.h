// Knots, parameters and control points of a mesh's fit, before its verdict.
#pragma once
#include "knotfit/fit_mesh.h"
namespace knotfit {

struct CorrectedFit {
  MeshFit fit;             ///< its status is the search's
  bool corrected = false;  ///< false: the fit is as it is, for the reason that its status or notes give
};

/// fit_mesh() up to the distances of the vertices.
CorrectedFit corrected_fit(const Mesh& mesh, const MeshMap& map, const FitOptions& options,
                           const CorrectionOptions& correction, const Control& control);

}  // namespace knotfit
