// Values, derivatives, normals and curvatures of a surface. Parameters outside the domain are
// clamped to it; a NaN parameter gives NaN.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "knotfit/surface.h"
namespace [[gnu::visibility("default")]] knotfit {

/// S(u,v). Error at most (degree_u + degree_v + 2) 4 eps scale() a component.
/// \param out  dimension entries, written
void evaluate(const Surface& s, double u, double v, std::span<double> out);

/// All derivatives d^{a+b} S / du^a dv^b with a + b <= order.
/// \return (order + 1) x (order + 1) x dimension; entry (a, b) at [(a*(order+1) + b)*dimension],
///   zero where a + b > order
std::vector<double> evaluate_derivatives(const Surface& s, double u, double v, int order);

/// One derivative (default: the value) at many parameters, sorted by span inside and threaded;
/// the same bits as one at a time.
/// \param uv  n x 2, row-major   \return n x dimension, in the order given
std::vector<double> evaluate(const Surface& s, std::span<const double> uv, int derivative_u = 0,
                             int derivative_v = 0);

/// The same on a tensor grid, direction by direction. \return u.size() x v.size() x dimension
std::vector<double> evaluate_grid(const Surface& s, std::span<const double> u, std::span<const double> v,
                                  int derivative_u = 0, int derivative_v = 0);

/// Differential geometry at one point of a surface in R^3 [do Carmo].
struct LocalGeometry {
  std::array<double, 3> point{}, normal{};  ///< unit normal S_u x S_v / |.|; zero where degenerate
  double mean_curvature = 0;                ///< H, sign by the normal
  double gaussian_curvature = 0;            ///< K
  double k1 = 0, k2 = 0;                    ///< principal curvatures, k1 >= k2
  double area_element = 0;                  ///< |S_u x S_v|
  bool degenerate = false;                  ///< |S_u x S_v| below 1e-12 |S_u||S_v|: no normal
};
/// \throws InvalidInput  the surface is not in R^3
LocalGeometry local_geometry(const Surface& s, double u, double v);

}  // namespace knotfit
