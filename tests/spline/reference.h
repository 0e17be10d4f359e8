// Slow and obvious: the definition of a B-spline by recursion, in long double.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "knotfit/surface.h"
namespace knotfit::test {

using Long = long double;

/// B_i of degree p at x inside span, or its r-th derivative, by the Cox-de Boor recursion
/// [deBoor01 (IX.14), (X.8)]; 0/0 is 0. `magnitude` sums |terms| of the derivative's differences.
struct Reference {
  const KnotVector& t;
  Index span;
  Long x;
  bool magnitude = false;

  Long knot(Index i) const { return t[i]; }
  static Long ratio(Long a, Long b) { return b == 0 ? 0 : a / b; }
  Long operator()(Index i, int p, int r = 0) const {
    if (r > p || i + p < span || i > span) return 0;
    if (p == 0) return 1;
    const Long left = knot(i + p) - knot(i), right = knot(i + p + 1) - knot(i + 1);
    if (r == 0)
      return ratio(x - knot(i), left) * (*this)(i, p - 1) +
             ratio(knot(i + p + 1) - x, right) * (*this)(i + 1, p - 1);
    const Long a = ratio(p, left) * (*this)(i, p - 1, r - 1),
               b = ratio(p, right) * (*this)(i + 1, p - 1, r - 1);
    return magnitude ? std::abs(a) + std::abs(b) : a - b;
  }
};

/// The span by trying them all: half open, the last one closed.
inline Index reference_span(const KnotVector& t, double x) {
  Index found = -1;
  for (Index i = t.degree(); i < t.size(); ++i)
    if (t[i] < t[i + 1] && (t[i] <= x || found < 0)) found = i;
  return found;
}

inline double clamp_to(const KnotVector& t, double x) {
  return std::min(std::max(x, t.first()), t.last());
}

/// d^{a+b} S / du^a dv^b in long double over every function of the basis that is not zero.
inline std::vector<Long> reference_value(const Surface& s, double u, double v, int a = 0, int b = 0,
                                         bool magnitude = false) {
  u = clamp_to(s.knots_u(), u);
  v = clamp_to(s.knots_v(), v);
  const Reference bu{s.knots_u(), reference_span(s.knots_u(), u), u, magnitude};
  const Reference bv{s.knots_v(), reference_span(s.knots_v(), v), v, magnitude};
  std::vector<Long> row;
  for (Index j = bv.span - s.degree_v(); j <= bv.span; ++j) row.push_back(bv(j, s.degree_v(), b));
  std::vector<Long> sum(static_cast<std::size_t>(s.dimension()), 0);
  for (Index i = bu.span - s.degree_u(); i <= bu.span; ++i) {
    const Long value = bu(i, s.degree_u(), a);
    for (Index k = 0; k <= s.degree_v(); ++k)
      for (int d = 0; d < s.dimension(); ++d) {
        const Long c = s.control_point(i, bv.span - s.degree_v() + k)[d];
        sum[d] += value * row[k] * (magnitude ? std::abs(c) : c);
      }
  }
  return sum;
}

}  // namespace knotfit::test
