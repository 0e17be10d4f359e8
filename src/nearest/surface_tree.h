// The closest point of a whole surface, by triangles with a bound on the surface's distance from them [METHOD 8.14].
#pragma once
#include <optional>

#include "nearest/cell_polynomials.h"
#include "nearest/triangle_tree.h"
namespace knotfit {

class SurfaceTree {
 public:
  /// Cuts every cell into 2 x 2 to 32 x 32 pairs of triangles: as many as keep the surface near them, within 1e-4 of its
  /// diagonal.
  explicit SurfaceTree(const CellPolynomials& surface);

  struct Closest {
    double u = 0, v = 0, squared = 0;
  };
  /// \param start  u, v to look from first; null: none
  Closest closest(const Vec3& p, const double* start = nullptr) const;

 private:
  struct Patch {
    double u0, u1, v0, v1;  ///< a rectangle; each of its halves is a triangle
    Index span_u, span_v;
    double margin;  ///< the surface over a triangle is at most so far from it
  };
  const CellPolynomials& surface_;
  std::vector<Patch> patches_;  ///< two triangles each
  double margin_ = 0;           ///< the largest of theirs
  std::optional<TriangleTree> tree_;
};

}  // namespace knotfit
