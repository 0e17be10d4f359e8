#include "fit/knot_basis.h"

#include <algorithm>
namespace knotfit {

void KnotBasis::set(const Axis& axis, const std::vector<double>& derivatives, double parameter) {
  const int w = axis.width(), alive = 2 * axis.degree();
  span = axis.span(parameter);
  std::array<double, kMaxDegree + 1> legendre{};
  legendre_values(axis.local(span, parameter), w, legendre.data());
  const auto sum = [&](const double* table, double* out) {
    std::fill_n(out, w, 0.0);
    for (int a = 0; a < w; ++a)
      for (int i = 0; i < w; ++i) out[i] += legendre[a] * table[a * w + i];
  };
  sum(axis.basis(span), value.data());
  if (derivatives.empty()) return;
  for (int e = 0; e < alive; ++e) sum(derivatives.data() + (span * alive + e) * w * w, by_knot[e].data());
}

}  // namespace knotfit
