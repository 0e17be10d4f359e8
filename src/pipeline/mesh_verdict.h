// Distances to the surface as the errors of a result, and the verdict on them.
#pragma once
#include <vector>

#include "knotfit/fit_mesh.h"
namespace knotfit {

/// Points, distances and where they are of `fit`, its errors, and what they are at the points' parameters. The surface, and
/// the tolerance where there is one, are in its result.
/// \param points  at the corrected parameters
/// \param signed_distances  n, of the points  \param feet  n x 2, of their closest points of the surface
/// \return false: de Boor's algorithm at the feet finds other distances; the result says so
bool take_distances(MeshFit& fit, ParameterizedPoints points, std::vector<double> signed_distances,
                    std::vector<double> feet);

/// The tolerance, by the errors.
bool holds_tolerance(const MeshFit& fit);

/// Status, measured, reached, notes and message, from the errors, the folds and the distances to the mesh. The status
/// so far is the search's.
void give_verdict(MeshFit& fit, const FitOptions& options);

}  // namespace knotfit
