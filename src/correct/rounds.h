// The schedule of a correction, in its own frame [METHOD 8.1].
#pragma once
#include <cmath>

#include "base/stage.h"
#include "correct/holding_mesh.h"
#include "correct/merit.h"
#include "fit/knot_jacobian.h"
#include "knotfit/correct.h"
namespace knotfit::correction {

struct Rounds {
  std::optional<Surface> surface;  ///< the best; none: singular
  std::vector<double> uv;          ///< of the vertices of the mesh given, at it
  std::vector<CorrectionRound> rounds;
  Index best = 0;
  double error = 0, folded = 0;  ///< of the best: the error that counts, the folded share
  bool stopped = false;
  double merit() const { return surface ? merit_of(error, folded) : INFINITY; }  ///< of the best
};

/// \param mesh        lengths over the diagonal
/// \param options     checked; start and keep_by in the frame
/// \param keep_start  the best may be what the rounds began with
Rounds run_rounds(HoldingMesh mesh, const KnotVector& knots_u, const KnotVector& knots_v,
                  const CorrectionOptions& options, const Stage& stage, bool keep_start = true);

/// How the sum of the last step changes with the knots, at these parameters.
/// \param surface  over its knots, in the frame
std::optional<KnotJacobian> knot_jacobian(HoldingMesh mesh, const Surface& surface,
                                          const CorrectionOptions& options);

}  // namespace knotfit::correction
