// Rounds on one state of the holding mesh: what each of them is made of.
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

inline constexpr double kLaterFairness = 0.3;  ///< share of the fairness in the second half of the rounds

/// A surface judged: distances after one free foot point step, and folds.
struct Verdict {
  double rms = 0, max = 0;
  double error = 0;  ///< the error that counts
  double folded = 0;
  double merit = INFINITY;      ///< merit_of() the RMS
  std::vector<double> squared;  ///< distances, by point
};

class Batch {
 public:
  /// \param mesh, system, u, v, options  outlive the batch; the mesh's parameters are moved
  Batch(HoldingMesh& mesh, const TangentSystem& system, const SpanTable& u, const SpanTable& v,
        const CorrectionOptions& options);

  /// Renews what follows from the parameters: weights of added vertices, the blurred mesh.
  void begin_round();
  std::optional<Surface> plain_fit() const;

  /// Moves the parameters to guarded foot points. \return vertices held
  Index move(const CellPolynomials& surface);

  /// Weights of the points: the data's raised to 1 + kappa min(d / RMS, 8)^2, their sum kept.
  std::vector<double> weights(double kappa, const std::vector<double>& squared) const;
  /// Weights of the points, the data's times `factor`, their sum kept. \param factor  by point
  std::vector<double> weights(const std::vector<double>& factor) const;

  std::optional<Surface> step(const CellPolynomials& surface, double tangential, const HingeState& hinge,
                              const std::vector<double>& weights) const;
  /// Of the step's sum in the knots, at the surface.
  std::optional<KnotJacobian> knot_jacobian(const Surface& surface, double tangential,
                                            const HingeState& hinge,
                                            const std::vector<double>& weights) const;
  Verdict judge(const CellPolynomials& surface) const;
  /// \param weights  of the cells; renewed where asked: cells that fold weigh more from now on
  /// \param fairness  share of the option's that is charged
  HingeState hinge(const CellPolynomials& surface, std::vector<double>& weights, bool renew,
                   double fairness) const;

  void set_parameters(std::vector<double> uv);
  bool is_data(std::size_t point) const { return base_[point] > 0; }

 private:
  void gather();
  std::vector<Sym3> matrices(const CellPolynomials& surface, double tangential) const;

  HoldingMesh& mesh_;
  const TangentSystem& system_;
  const SpanTable &u_, &v_;
  const CorrectionOptions& options_;
  ParameterGuard guard_;
  std::vector<Slide> slides_;  ///< by vertex
  PointWeights points_;
  std::vector<double> base_;  ///< 1 / n for the data, else 0
  std::vector<Vec3> position_;
  std::vector<Slide> slide_;
  std::vector<double> uv_;
  std::vector<double> free_;  ///< foot points that no guard holds: the distances are measured there
  FootPointOptions steps_;
  Reference reference_;
  double resolved_;  ///< how far the mesh shows the curvature of a surface of these knots, 0 to 1
};

/// from + share (to - from), over the same knots.
Surface between(const Surface& from, const Surface& to, double share);

}  // namespace knotfit::correction
