// Sizes for a mesh whose parameters move: each begins with the surface and the parameters of a smaller
// one [METHOD 8.12].
#pragma once
#include <string>
#include <vector>

#include "correct/prepared_mesh.h"
#include "knotfit/refine.h"
namespace knotfit {

struct MeshSearch {
  Status status = Status::not_run;
  CorrectionResult correction;  ///< of the best: the fewest control points that hold, else the least error
  std::vector<SizeTried> tried;
  long fits = 0;
  std::string method;
};

/// The fewest control points that hold the tolerance without folds. Sizes grow by two fifths; then, from the last
/// that failed, by a twentieth to the first that holds. The path from size to size does not depend on the
/// tolerance, so that a looser one does not ask for more.
/// \param tolerance  in the frame of the mesh
MeshSearch search_mesh_sizes(const correction::PreparedMesh& prepared, const SearchOptions& options,
                             const Tolerance& tolerance, const Control& control);

/// A fixed size: corrected on uniform knots, then on those of the error model on that surface, then with the knots
/// optimised too, as far as the method asks; each kept only where the error falls.
MeshSearch fit_mesh_size(const correction::PreparedMesh& prepared, const SearchOptions& options, int size_u,
                         int size_v, const Tolerance& tolerance, const Control& control);

}  // namespace knotfit
