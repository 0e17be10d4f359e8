// The closest point of a whole surface: triangles with a bound on how far the surface leaves them [METHOD 8.14].
#pragma once
#include <optional>

#include "nearest/cell_polynomials.h"
#include "nearest/triangle_tree.h"
namespace knotfit {

class SurfaceTree {
 public:
  /// Every cell in as many pairs of triangles as keep the surface within 1e-4 of its own diagonal of them
  /// (2 x 2 to 32 x 32 a cell).
  explicit SurfaceTree(const CellPolynomials& surface);

  struct Closest {
    double u = 0, v = 0, squared = 0;
  };
  /// \param start  u, v to look from first; null: none
  Closest closest(const Vec3& p, const double* start = nullptr) const;

 private:
  struct Patch {
    double u0, u1, v0, v1;  ///< the rectangle whose half the triangle is
    Index span_u, span_v;
    double margin;  ///< the surface over it is no farther from the triangle
  };
  const CellPolynomials& surface_;
  std::vector<Patch> patches_;  ///< two triangles each
  double margin_ = 0;           ///< the largest
  std::optional<TriangleTree> tree_;
};

}  // namespace knotfit
