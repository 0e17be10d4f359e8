// Parameters and control points together: what a mesh's fit gains where its parameters may move.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/distance.h"
#include "knotfit/folds.h"
#include "knotfit/mesh.h"
#include "knotfit/parameterize_mesh.h"
#include "knotfit/surface.h"
#include "knotfit/tolerance.h"
namespace [[gnu::visibility("default")]] knotfit {

enum class CorrectionStep {
  tangent,  ///< distances along the normals, a share of those in the tangent plane [Wang06]
  point     ///< plain least squares at the foot points [Hoschek88]
};

struct CorrectionOptions {
  CorrectionStep step = CorrectionStep::tangent;
  int rounds = 30;  ///< 0: the plain fit at the parameters given
  /// Rows that keep the surface from folding over the mesh, of the tangent step.
  bool hinge = true;
  /// Weight of the curvature data, of the tangent step: against ruffles that do not turn back; at least 0, 0: none.
  /// Ten times the default is fairer at the price of larger distances.
  double fairness = 1e-3;
  bool slide = true;           ///< boundary vertices slide along their side
  bool round_corners = false;  ///< and past its ends; else the four corners stay
  /// kappa: in the second half of the rounds points weigh 1 + kappa min(distance / RMS, 8)^2. 0.1 suits an RMS
  /// or a percentile, 1 a maximum.
  double reweighting = 0.1;
  double gradient = 1e-3;   ///< weight of the mesh map's gradients
  double holding = 0.3;     ///< weight of vertices added in long edges
  double smoothing = 1e-9;  ///< relative floor, as LeastSquaresOptions
  double aspect = 0;  ///< width over height of the rectangle that suits the map (MapQuality); 0: measured
  std::optional<Surface> start = {};  ///< over the same knots, to begin with; else the plain fit
  /// The error that the best round is kept by, in the mesh's unit; the rounds end once it is at most the value
  /// (0: all rounds) and nothing folds.
  Tolerance keep_by{.value = 0, .measure = ErrorMeasure::rms};
  /// Rounds after the others that lower the largest distance, or the percentile of keep_by, by L_P weights.
  int minimax_rounds = 0;
  Index data_vertices = -1;  ///< only the first so many are data; -1: all
};

/// What a round left.
struct CorrectionRound {
  double rms = 0, max = 0;  ///< distances of the data to the surface
  double folded = 0;        ///< share of the square where the surface turns against the blurred mesh
  double tangential = 0;    ///< share of the distance in the tangent plane that was charged
  double step = 1;          ///< share of the control points' step that was taken
  Index held = 0;           ///< vertices the guard held back
  Index hinge_rows = 0;
};

enum class CorrectionStatus {
  not_run,
  corrected,
  no_gain,   ///< no round was better than the plain fit: the parameters are those given
  singular,  ///< the control points could not be solved for
  stopped    ///< cut short: the best so far
};

struct CorrectionResult {
  CorrectionStatus status = CorrectionStatus::not_run;
  std::vector<double> uv;    ///< n x 2, corrected, in [0,1]; no triangle that lay right is turned over
  Surface surface;           ///< in the mesh's own coordinates
  DistanceSummary distance;  ///< of the data vertices to the whole surface, signed by its normal
  std::vector<double> signed_distances;  ///< n; NaN where a vertex is no data
  std::vector<double> foot_points;       ///< n x 2, of those distances; NaN likewise
  FoldReport folds;                      ///< at the corrected parameters
  std::vector<CorrectionRound> rounds;   ///< the plain fit first
  Index best_round = 0;
};

/// Alternates foot points and control points on fixed knots [METHOD 8.1]: the tangent step of Wang et
/// al., held between the vertices by the gradients of the mesh map, kept from folding by hinge rows on the
/// singular values of the surface against the blurred mesh, drawn to the blurred mesh's curvature where the normals are
/// far apart (docs/decisions/0008), with no parameter triangle ever turned over. The best
/// round by RMS (1 + 20 folded share) is kept. The same bits for any number of threads.
/// \param mesh  any mesh whose triangles lie right at uv; virtual faces are parameterized, never data
/// \param uv    n x 2 in [0,1]
/// \throws InvalidInput  uv of another length, outside [0,1] or not finite; knots not clamped on [0,1]; fewer data
///   vertices than 4; options out of range; a start over other knots
CorrectionResult correct_parameters(const Mesh& mesh, const std::vector<double>& uv,
                                    const KnotVector& knots_u, const KnotVector& knots_v,
                                    const CorrectionOptions& options = {}, const Control& control = {});

/// The same from a map: on its halved edges, with its aspect. uv, distances and foot points are those of the
/// mesh's own vertices.
CorrectionResult correct_parameters(const Mesh& mesh, const MeshMap& map, const KnotVector& knots_u,
                                    const KnotVector& knots_v, const CorrectionOptions& options = {},
                                    const Control& control = {});

}  // namespace knotfit
