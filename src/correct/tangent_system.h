// The control points of one round, from points with a matrix each and what holds the surface between them [METHOD 8.5].
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "fit/knot_jacobian.h"
#include "knotfit/surface.h"
#include "solve/axis.h"
#include "solve/banded.h"
namespace knotfit::correction {

/// A symmetric 3 x 3 matrix.
struct Sym3 {
  double xx = 1, xy = 0, xz = 0, yy = 1, yz = 0, zz = 1;
};
/// a I + b n n^T
inline Sym3 with_axis(double a, double b, const Vec3& n) {
  return {a + b * n.x * n.x, b * n.x * n.y, b * n.x * n.z,
          a + b * n.y * n.y, b * n.y * n.z, a + b * n.z * n.z};
}
inline Vec3 operator*(const Sym3& m, const Vec3& p) {
  return {m.xx * p.x + m.xy * p.y + m.xz * p.z, m.xy * p.x + m.yy * p.y + m.yz * p.z,
          m.xz * p.x + m.yz * p.y + m.zz * p.z};
}

/// weight_u |S_u - xu|^2 + weight_v |S_v - xv|^2 at (u,v).
struct GradientDatum {
  double u, v, weight_u, weight_v;
  Vec3 xu, xv;
};

/// weight (y . (a S_u + b S_v) - target)^2 at (u,v).
struct HingeRow {
  double u, v, a, b;
  Vec3 y;
  double target, weight;
};

/// sum_k weight_k (n . D_k - target_k)^2 at (u,v), D = S_uu, S_uv, S_vv.
struct CurvatureDatum {
  double u, v;
  Vec3 n;
  std::array<double, 3> weight, target;
};

/// What holds the surface between the points.
struct Holding {
  std::span<const GradientDatum> gradient;
  std::span<const HingeRow> hinge;  ///< as the next, only with the points' matrices
  std::span<const CurvatureDatum> curvature = {};
};

struct SystemPoints {
  std::span<const double> uv;
  std::span<const Vec3> point;
  std::span<const double> weight;
  std::span<const Sym3> matrix;  ///< empty: I, the point distance
};

class TangentSystem {
 public:
  /// \param aspect  width over height of the rectangle that the thin-plate energy is taken on
  TangentSystem(const KnotVector& u, const KnotVector& v, double aspect);

  /// Minimises sum w (S - P)^T M (S - P) + lambda J + what holds the surface. The same bits for any number of threads.
  /// \param smoothing  lambda tr(J) / tr(A^T W A)
  /// \return nothing where no floor up to 1e-5 makes the matrix positive definite
  std::optional<Surface> solve(const SystemPoints& points, double smoothing, const Holding& holding) const;

  /// How the points' part of that sum changes with the knots, the control points eliminated: Kaufman's variable projection
  /// [METHOD 3.1, 8.11]. Smoothing and what holds the surface hold the control points. Needs the points' matrices, and
  /// simple knots.
  /// \param surface  over the system's knots, a minimiser of the whole sum
  /// \param counts   by point: 1 where it is in the sum that is to fall; the others only hold the control points
  std::optional<KnotJacobian> knot_jacobian(const SystemPoints& points, double smoothing,
                                            const Holding& holding, const Surface& surface,
                                            std::span<const char> counts) const;

 private:
  /// The normal equations without the smoothing.
  struct Sum {
    int block;                ///< 3, or 1 where the three coordinates do not meet
    BandMatrix matrix;        ///< of blocks
    BandMatrix scalar;        ///< the same for each coordinate
    std::vector<double> rhs;  ///< block 1: coordinate after coordinate; 3: three to a control point
    double trace;             ///< tr(A^T W A)
  };
  Sum summed(const SystemPoints& points, const Holding& holding) const;
  /// With the smoothing. \return nothing where the matrix is not positive definite
  std::optional<BandMatrix> factored(const Sum& sum, double smoothing) const;
  auto numbers() const {
    return [this](Index i, Index j) { return index(i, j); };
  }
  /// The number of a function in the system.
  Index index(Index i, Index j) const { return swapped_ ? j * u_.functions() + i : i * v_.functions() + j; }
  void add_points(const SystemPoints& points, Sum& sum) const;
  void add_gradient(std::span<const GradientDatum> data, Sum& sum) const;
  void add_hinge(std::span<const HingeRow> rows, Sum& sum) const;
  void add_curvature(std::span<const CurvatureDatum> data, Sum& sum) const;

  KnotVector knots_u_, knots_v_;
  Axis u_, v_;
  bool swapped_ = false;  ///< u runs inside: it has fewer functions
  BandMatrix energy_;
};

}  // namespace knotfit::correction
