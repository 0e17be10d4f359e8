// The mesh of a correction at its present parameters, with what follows from them: the steps of a round.
#pragma once
#include <cmath>
#include <optional>
#include <vector>

#include "correct/holding_mesh.h"
#include "correct/map_hold.h"
#include "correct/parameter_guard.h"
#include "correct/tangent_system.h"
#include "knotfit/correct.h"
namespace knotfit::correction {

inline constexpr double kLaterFairness =
    0.3;  ///< share of the fairness in the second half of the rounds: set

/// What stays while the parameters move.
struct FixedKnots {
  SpanTable u, v;
  TangentSystem system;
  FixedKnots(const KnotVector& knots_u, const KnotVector& knots_v, double aspect)
      : u(knots_u), v(knots_v), system(knots_u, knots_v, aspect) {}
};

/// Of a surface: distances after one foot-point step that no guard holds, and folds.
struct Judgement {
  double rms = 0, max = 0;
  double error = 0;  ///< the error that counts
  double folded = 0;
  double penalised_error = INFINITY;  ///< of the RMS
  std::vector<double> squared;        ///< distances, by point
};

/// Its points are the vertices of faces that are data: the mesh's own, and those added in long edges.
class MeshAtParameters {
 public:
  /// Halves the long edges of the mesh. \param mesh, knots, options  outlive this; the mesh's parameters are moved
  MeshAtParameters(HoldingMesh& mesh, const FixedKnots& knots, const CorrectionOptions& options);

  /// Renews the weights of added vertices and the blurred mesh, after the parameters moved.
  void begin_round();
  std::optional<Surface> plain_fit() const;

  /// Moves the parameters to guarded foot points. \return vertices held
  Index move(const CellPolynomials& surface);
  void set_parameters(std::vector<double> uv);

  /// By point: 1 / n for the data, by its area for an added vertex.
  const std::vector<double>& weights() const { return points_.weight; }
  /// The same with the data's times 1 + kappa min(d / RMS, 8)^2, their sum kept.
  std::vector<double> weights(double kappa, const std::vector<double>& squared) const;
  /// The same with the data's times `factor`, by point, their sum kept.
  std::vector<double> weights(const std::vector<double>& factor) const;

  /// \param tangential  share of the distance in the tangent plane that is charged
  std::optional<Surface> step(const CellPolynomials& surface, double tangential, const HingeState& hinge,
                              const std::vector<double>& weights) const;
  /// How the sum that the step minimises changes with the knots, at the surface.
  std::optional<KnotJacobian> knot_jacobian(const Surface& surface, double tangential,
                                            const HingeState& hinge,
                                            const std::vector<double>& weights) const;
  Judgement judge(const CellPolynomials& surface) const;
  /// \param weights   of the cells. \param renew  cells that fold weigh more from now on, the others less
  /// \param fairness  share of the option's that is charged
  HingeState hinge(const CellPolynomials& surface, std::vector<double>& weights, bool renew,
                   double fairness) const;

  bool is_data(std::size_t point) const { return base_[point] > 0; }

 private:
  void gather();
  std::vector<Sym3> matrices(const CellPolynomials& surface, double tangential) const;

  HoldingMesh& mesh_;
  const FixedKnots& knots_;
  const CorrectionOptions& options_;
  ParameterGuard guard_;
  std::vector<Slide> slides_;  ///< by vertex
  PointWeights points_;
  std::vector<double> base_;  ///< 1 / n for the data, else 0
  std::vector<Vec3> position_;
  std::vector<Slide> slide_;
  std::vector<double> uv_;
  std::vector<double> free_;  ///< foot points that no guard holds: distances are measured from them
  FootPointOptions steps_;
  Reference reference_;
  double resolved_;  ///< how much of a surface's curvature, over these knots, the mesh shows: 0 to 1
};

/// from + share (to - from), over the same knots.
Surface between(const Surface& from, const Surface& to, double share);

}  // namespace knotfit::correction
