#include "parameterize/mesh_stretch_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>
namespace knotfit::mesh_map {

double stretch_energy(const Jacobian& j, double theta) {
  const double d = j.determinant(), q = j.squared_norm();
  return d > 0 ? q / (d * d) + theta * q : std::numeric_limits<double>::infinity();
}

EnergyDerivatives stretch_energy_derivatives(const Jacobian& j, double theta, bool projected) {
  // J as a sum of a similarity and a reflected one: Q +- R are the singular values.
  const double e = 0.5 * (j.xu + j.yv), h = 0.5 * (j.yu - j.xv), f = 0.5 * (j.xu - j.yv),
               g = 0.5 * (j.yu + j.xv);
  const double s1 = std::hypot(e, h) + std::hypot(f, g), s2 = j.determinant() / s1;
  const double plus = std::atan2(h, e), minus = std::atan2(g, f);
  const double left = 0.5 * (plus + minus), right = 0.5 * (plus - minus);
  const double uc = std::cos(left), us = std::sin(left), vc = std::cos(right), vs = std::sin(right);
  // U D V^T with U = [uc -us; us uc], V^T = [vc -vs; vs vc], for the four D, row by row.
  const double r = std::sqrt(0.5);
  const double axis[4][4] = {
      {uc * vc, -uc * vs, us * vc, -us * vs},  // diag(1, 0)
      {-us * vs, -us * vc, uc * vs, uc * vc},  // diag(0, 1)
      {r * (-uc * vs - us * vc), r * (-uc * vc + us * vs), r * (-us * vs + uc * vc),
       r * (-us * vc - uc * vs)},
      {r * (uc * vs - us * vc), r * (uc * vc + us * vs), r * (us * vs + uc * vc), r * (us * vc - uc * vs)}};
  const double i1 = 1 / (s1 * s1), i2 = 1 / (s2 * s2);
  const double f1 = 2 * theta * s1 - 2 * i1 / s1, f2 = 2 * theta * s2 - 2 * i2 / s2;
  const double twist = (f1 + f2) / (s1 + s2), product = s1 * s2;
  const double value[4] = {2 * theta + 6 * i1 * i1, 2 * theta + 6 * i2 * i2,
                           projected ? std::max(twist, 0.0) : twist,
                           2 * theta + 2 * (s1 * s1 + product + s2 * s2) / (product * product * product)};
  EnergyDerivatives result{};
  for (int a = 0; a < 4; ++a) {
    result.gradient[a] = f1 * axis[0][a] + f2 * axis[1][a];
    for (int b = 0; b <= a; ++b) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) sum += value[k] * axis[k][a] * axis[k][b];
      result.hessian[a][b] = result.hessian[b][a] = sum;
    }
  }
  return result;
}

}  // namespace knotfit::mesh_map
