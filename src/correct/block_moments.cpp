#include "correct/block_moments.h"

#include "base/clones.h"
#include "solve/axis.h"

namespace knotfit::correction {
namespace {

constexpr int kMost = 24;  // padded_moments(2 * kMaxDegree + 1)

/// \param qo, qi, stride  constants where the degrees are common ones
[[gnu::always_inline]] inline double add(std::span<const BlockPoint> points, int wo, int wi,
                                         const double* basis_outer, const double* basis_inner, int parts,
                                         double* moments, double* right) {
  const int qo = 2 * wo - 1, qi = 2 * wi - 1, stride = (qi + 7) / 8 * 8;
  alignas(64) double p[kMost] = {}, q[kMost] = {};
  double bo[kMaxDegree + 1], bi[kMaxDegree + 1], trace = 0;
  for (const BlockPoint& point : points) {
    legendre_values(point.t, qo, p);
    legendre_values(point.s, qi, q);
    for (int c = 0; c < parts; ++c)
      for (int a = 0; a < qo; ++a) {
        const double f = point.matrix[c] * p[a];
        double* row = moments + (c * qo + a) * stride;
        for (int b = 0; b < stride; ++b) row[b] += f * q[b];
      }
    for (int i = 0; i < wo; ++i) bo[i] = 0;
    for (int i = 0; i < wi; ++i) bi[i] = 0;
    for (int a = 0; a < wo; ++a)
      for (int i = 0; i < wo; ++i) bo[i] += p[a] * basis_outer[a * wo + i];
    for (int a = 0; a < wi; ++a)
      for (int i = 0; i < wi; ++i) bi[i] += q[a] * basis_inner[a * wi + i];
    double so = 0, si = 0;
    for (int i = 0; i < wo; ++i) so += bo[i] * bo[i];
    for (int i = 0; i < wi; ++i) si += bi[i] * bi[i];
    trace += point.weight * so * si;
    for (int d = 0; d < 3; ++d)
      for (int i = 0; i < wo; ++i) {
        const double f = point.rhs[d] * bo[i];
        for (int j = 0; j < wi; ++j) right[(d * wo + i) * wi + j] += f * bi[j];
      }
  }
  return trace;
}

/// Local, as a shared library would export its chooser otherwise.
KNOTFIT_CLONES double add_clones(std::span<const BlockPoint> points, int degree_outer, int degree_inner,
                                 const double* basis_outer, const double* basis_inner, int parts,
                                 double* moments, double* right) {
  if (degree_outer == 3 && degree_inner == 3)
    return add(points, 4, 4, basis_outer, basis_inner, parts, moments, right);
  return add(points, degree_outer + 1, degree_inner + 1, basis_outer, basis_inner, parts, moments, right);
}

}  // namespace

double add_block_moments(std::span<const BlockPoint> points, int degree_outer, int degree_inner,
                         const double* basis_outer, const double* basis_inner, int parts, double* moments,
                         double* right) {
  return add_clones(points, degree_outer, degree_inner, basis_outer, basis_inner, parts, moments, right);
}

}  // namespace knotfit::correction
