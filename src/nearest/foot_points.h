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
  round     ///< along the border, past its corners too
};

struct FootPointOptions {
  int iterations = 3;
  double longest_u = 1, longest_v = 1;  ///< of one step
};

/// Minimises |S(u,v) - P|^2 by Gauss-Newton steps [METHOD 8.3]. A step is halved while the distance does not fall. A
/// coordinate at the end of the domain stays there while the gradient points outward. Points are taken in the order of
/// their cells, on several threads; the bits of a point depend on nothing but itself.
/// \param slide  one a point; empty: all free
/// \param uv     n x 2 in the domain, moved; no distance grows
/// \param jets   n, written: at the foot points; may be empty
/// \return squared distances
std::vector<double> foot_points(const CellPolynomials& surface, std::span<const Vec3> points,
                                std::span<const Slide> slide, const FootPointOptions& options,
                                std::span<double> uv, std::span<Jet> jets = {});

/// Goes on from near a foot point to rounding, by Newton steps where the Hessian is positive definite [Piegl97 6.1].
/// \param uv  in the domain, moved   \return squared distance
double polish(const CellPolynomials& surface, const Vec3& point, double* uv);
/// The same inside one closed cell: its polynomial has no creases.
double polish_in_cell(const CellPolynomials& surface, Index span_u, Index span_v, const Vec3& point,
                      double* uv);

}  // namespace knotfit
