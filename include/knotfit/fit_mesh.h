// The whole way for a mesh: knots, then parameters and control points together, then distances both ways.
#pragma once
#include "knotfit/correct.h"
#include "knotfit/fit_surface.h"
namespace [[gnu::visibility("default")]] knotfit {

struct MeshFit {
  FitResult result;  ///< its errors are distances to the surface
  CorrectionResult correction;
  ParameterizedPoints points;  ///< the data, at the corrected parameters; result.errors are in its order
  std::vector<double> signed_distances;  ///< of the points, by the surface's normal
  std::vector<double> foot_uv;  ///< n x 2, of the closest points of the surface: where the errors are
  ErrorSummary at_parameters;   ///< |S - P| at the corrected parameters
  /// Points that would turn triangles over at their foot points: their error at the parameters is beyond the tolerance (the
  /// largest distance where there is none) and twice their distance; and the largest such error.
  Index off_foot = 0;
  double off_foot_error = 0;
  DistanceSummary to_mesh;  ///< of the surface to the mesh: waves and flaps away from the vertices
};

/// Corrects the parameters together with the control points, and judges by the distance: tolerance, status and
/// errors of the result are those of the corrected surface. A surface that strays from the mesh by more than twice the
/// tolerance is the first of the notes; folds that are left are among them. One that holds the tolerance and folds over more
/// than 0.1 % of the square, or in pleats narrower than a span over 0.5 % (folds_over), has the status folded.
///   A fixed size: corrected on uniform knots; method error-model: then on knots of that model on the corrected
/// surface; optimal: then with the knots optimised on the distances between the rounds; each kept where the error
/// falls. Knots given, or of another method: fit_surface() places them, the correction follows.
///   A tolerance: the correction is part of the size search. Each size begins with the surface and the parameters of
/// the one before and takes 2/5 of the rounds; near the tolerance L_P weights lower the maximum or percentile, and
/// knots move from uniform ones as far as the method asks: error-model, or with any other both that and steps on the
/// distances. At most 5 000 control points unless FitOptions says otherwise. Routes, effort and automatic degrees of
/// FitOptions do not count.
/// \throws InvalidInput  see fit_surface(), correct_parameters(); neither a tolerance nor a size nor knots are given
MeshFit fit_mesh(const Mesh& mesh, const MeshMap& map, const FitOptions& options,
                 const CorrectionOptions& correction = {}, const Control& control = {});

}  // namespace knotfit
