// How the mesh map holds the surface between the vertices: by its gradients, its normals and its curvature
// [METHOD 8.6, 8.7, 8.8].
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "correct/holding_mesh.h"
#include "correct/tangent_system.h"
namespace knotfit::correction {

/// The data of eps / G sum_g h_u^2 |S_u - X_u|^2 + h_v^2 |S_v - X_v|^2 over 3 x 3 places a cell, weighted by the cell's
/// area. Along the four sides the derivative along the side counts too, by a quarter of that [METHOD 8.6].
std::vector<GradientDatum> gradient_data(const HoldingMesh& mesh, const SpanTable& u, const SpanTable& v,
                                         double eps);

/// The mesh blurred over about a span, at 4 x 4 places a cell. The surface must not turn against it.
struct Reference {
  MapSamples grid;
  struct Sample {
    Vec3 n, t1, t2;    ///< mean normal, and the frame in its plane
    Vec3 xu, xv;       ///< mean derivatives
    double k[4] = {};  ///< K: 2 x 2, row-major
    bool used = false;
  };
  std::vector<Sample> samples;
  std::vector<double> centre_u, centre_v;  ///< by grid line: the centre of its window
  double mean_area = 0;                    ///< of |X_u x X_v|
};
inline constexpr int kReferencePerSpan = 4;
/// \param aspect  width over height of the rectangle that suits the map
Reference reference(const HoldingMesh& mesh, const SpanTable& u, const SpanTable& v, double aspect);

/// n . X_uu, n . X_uv, n . X_vv at a sample: n . X_uu = -n_u . X_u and so on, n_u from the mean normals half a span to
/// both sides. \return nothing where one of them has no mesh
std::optional<std::array<double, 3>> curvature_at(const Reference& reference, Index i, Index j);

struct HingeState {
  double folded = 0;             ///< share of the square with (S_u x S_v).n < 0
  std::vector<char> cell_folds;  ///< by cell
  std::vector<HingeRow> rows;
  std::vector<CurvatureDatum> curvature;
};
/// The hinge rows [METHOD 8.7], and against ruffles curvature data [METHOD 8.8]: where the surface's normal is more than
/// 15 degrees off the blurred mesh's (in full from 25 on)
///     fairness / G (h_u^4 (n.S_uu - n.X_uu)^2 + 2 h_u^2 h_v^2 (n.S_uv - n.X_uv)^2 + h_v^4 (n.S_vv - n.X_vv)^2),
/// weighted by the cell's area, G samples in all.
/// \param weights  k_c by cell; empty: the folded share alone
HingeState hinge_rows(const CellPolynomials& surface, const Reference& reference,
                      const std::vector<double>& weights, double fairness = 0);

}  // namespace knotfit::correction
