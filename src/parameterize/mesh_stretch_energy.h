// The energy that Newton's method brings down, a triangle at a time, with its exact derivatives.
#pragma once
#include "parameterize/mesh_rest.h"
namespace knotfit::mesh_map {

inline constexpr double kStretchTheta = 0.1;  ///< share of the forward map's stretch, keeps needles in hand

/// 1/s1^2 + 1/s2^2 + theta (s1^2 + s2^2), s1 and s2 the singular values of J; infinite where the
/// determinant is not positive.
double stretch_energy(const Jacobian& j, double theta = kStretchTheta);

struct EnergyDerivatives {
  double gradient[4];    ///< by xu, xv, yu, yv
  double hessian[4][4];  ///< its nearest positive semidefinite matrix where `projected`
};
/// Eigenpairs in closed form from J = U diag(s1, s2) V^T: stretching each axis, twist (the one that
/// can be negative, and is clamped at 0) and flip [Smith19].
/// \param j  of positive determinant
EnergyDerivatives stretch_energy_derivatives(const Jacobian& j, double theta = kStretchTheta,
                                             bool projected = true);

}  // namespace knotfit::mesh_map
