// Foot points of points near a surface, from parameters near them.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "nearest/cell_polynomials.h"
namespace knotfit {

/// Which way a parameter may go.
enum class Slide : std::uint8_t {
  free,     ///< anywhere in the domain
  along_v,  ///< u stays: on a side u = const
  along_u,  ///< v stays
  fixed,    ///< a corner
  round     ///< on the border, past its corners too
};

struct FootPointOptions {
  int iterations = 3;
  double longest_u = 1, longest_v = 1;  ///< of one step
};

/// Safeguarded Gauss-Newton on |S(u,v) - P|^2 [METHOD 8.3]: a step is halved while the distance
/// does not fall, a coordinate at the end of the domain stays there while the gradient points outward. In
/// batches, sorted by cell, threaded; the bits of a point depend on nothing but itself.
/// \param slide  one a point; empty: all free
/// \param uv     n x 2 in the domain, moved; no distance grows
/// \param jets   of the result, n; may be empty
/// \return squared distances
std::vector<double> foot_points(const CellPolynomials& surface, std::span<const Vec3> points,
                                std::span<const Slide> slide, const FootPointOptions& options,
                                std::span<double> uv, std::span<Jet> jets = {});

/// Newton with the full Hessian where that is positive definite, to rounding [Piegl97 6.1]; for one free point.
/// \param uv  in the domain, moved   \return squared distance
double polish(const CellPolynomials& surface, const Vec3& point, double* uv);
/// The same inside one cell, borders included: no crease stands in the way.
double polish_in_cell(const CellPolynomials& surface, Index span_u, Index span_v, const Vec3& point,
                      double* uv);

}  // namespace knotfit
