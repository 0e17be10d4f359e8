// The schedule of a correction, in the frame of the mesh [METHOD 8.1].
#pragma once
#include <cmath>

#include "base/stage.h"
#include "correct/holding_mesh.h"
#include "correct/penalised_error.h"
#include "fit/knot_jacobian.h"
#include "knotfit/correct.h"
namespace knotfit::correction {

/// What the rounds led to.
struct CorrectionRun {
  std::optional<Surface> surface;       ///< the best; none: the control points could not be solved for
  std::vector<double> uv;               ///< of the vertices of the mesh given, at the best
  std::vector<CorrectionRound> rounds;  ///< the start first
  Index best = 0;                       ///< its round
  double error = 0, folded = 0;         ///< of the best: the error that counts, the folded share
  bool stopped = false;
  double penalised_error() const { return surface ? correction::penalised_error(error, folded) : INFINITY; }
};

/// \param mesh        in its frame
/// \param options     checked; start and keep_by in the frame
/// \param keep_start  whether the start may be the best
CorrectionRun run_correction(HoldingMesh mesh, const KnotVector& knots_u, const KnotVector& knots_v,
                             const CorrectionOptions& options, const Stage& stage, bool keep_start = true);

/// How the distances of the data change with the knots: that of a tangent step at the feet of the surface. For simple
/// knots. \return nothing where the control points cannot be solved for
std::optional<KnotJacobian> knot_jacobian(HoldingMesh mesh, const Surface& surface,
                                          const CorrectionOptions& options);

}  // namespace knotfit::correction
