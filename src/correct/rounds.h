// The schedule of a correction, in its own frame.
#pragma once
#include "correct/holding_mesh.h"
#include "correct/tangent_system.h"
#include "correct/watch.h"
#include "knotfit/correct.h"
namespace knotfit::correction {

struct Rounds {
  std::optional<Surface> surface;  ///< the best; none: singular
  std::vector<double> uv;          ///< of the vertices of the mesh given, at it
  std::vector<CorrectionRound> rounds;
  Index best = 0;
  bool stopped = false;
};

/// \param mesh     lengths over the diagonal
/// \param options  checked; start in the frame
Rounds run_rounds(HoldingMesh mesh, const KnotVector& knots_u, const KnotVector& knots_v,
                  const CorrectionOptions& options, const Watch& watch);

}  // namespace knotfit::correction
