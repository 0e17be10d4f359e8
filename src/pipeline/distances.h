// Distances to the surface as the errors of a result.
#pragma once
#include <string>
#include <vector>

#include "knotfit/fit_mesh.h"
namespace knotfit {

/// Points, distances and where they are of `fit`, its errors, and what they are at the points' parameters. The surface, and
/// the tolerance where there is one, are in its result.
/// \param points  at the corrected parameters
/// \param signed_distances  n, of the points  \param feet  n x 2, of their closest points of the surface
/// \return false: de Boor's algorithm at the feet finds other distances
bool take_distances(MeshFit& fit, ParameterizedPoints points, std::vector<double> signed_distances,
                    std::vector<double> feet);

/// What a result says where that check failed.
std::string failed_check(const FitResult& result);

}  // namespace knotfit
