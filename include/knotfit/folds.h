// Where a surface folds over the mesh it was fitted to.
#pragma once
#include <span>
#include <vector>

#include "knotfit/mesh.h"
#include "knotfit/surface.h"
namespace [[gnu::visibility("default")]] knotfit {

/// A connected set of folded samples.
struct FoldPlace {
  double u = 0, v = 0;  ///< its sample with the least (S_u x S_v).m
  double share = 0;     ///< of the square
  double point[3] = {0, 0, 0};
};

/// 8 x 8 samples at the centres of equal parts of every knot cell, weighted by the cell's area; samples that no
/// triangle covers, or a virtual one, are left out [METHOD 8.9].
struct FoldReport {
  /// Shares of the square where S_u x S_v points against the mesh: against the mean unit normal of the mesh over
  /// +-4 samples, about a span; against the normal of the triangle there.
  double blurred = 0, raw = 0;
  /// Of `raw` the part over triangles that agree with those around them: pleats narrower than a span. The rest is noise of
  /// single triangles, which stand against any smooth surface.
  double pleats = 0;
  /// Angle between the surface's normal and that mean normal, RMS over the square, degrees: ruffles that do not turn
  /// back show here.
  double normal_angle = 0;
  Index flipped = 0;  ///< triangles turned over or flat in the parameters, by exact predicates
  /// Least |S_u x S_v| over its mean, and over |S_u||S_v|; shares below 0.05 of either.
  double least_area = 0, least_sine = 0;
  double small_area = 0, small_sine = 0;
  double covered = 0;             ///< share of the square under triangles that are not virtual
  std::vector<FoldPlace> places;  ///< blurred folds, the largest first
};

/// Folded shares up to which a surface holds [METHOD 8.9].
inline constexpr double kMostBlurredFold = 1e-3, kMostPleats = 5e-3;
inline bool folds_over(const FoldReport& folds) {
  return folds.blurred > kMostBlurredFold || folds.pleats > kMostPleats;
}

/// \param uv  n x 2, parameters of the vertices
/// \throws InvalidInput  an empty surface, or one not in R^3; uv that is not 2 numbers a vertex or not finite;
///   a mesh whose triangles cover no sample
FoldReport measure_folds(const Surface& surface, const Mesh& mesh, std::span<const double> uv);

}  // namespace knotfit
