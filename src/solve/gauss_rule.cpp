#include "solve/gauss_rule.h"

#include <algorithm>
#include <cmath>

#include "solve/axis.h"
namespace knotfit {

GaussRule::GaussRule(int n) : node(n), weight(n), legendre(n * n) {
  std::vector<double> p(std::max(2, n + 1));
  for (int g = 0; g < n; ++g) {
    double x = std::cos(M_PI * (g + 0.75) / (n + 0.5)), slope = 1;
    for (int newton = 0; newton < 100; ++newton) {
      legendre_values(x, n + 1, p.data());
      slope = n * (x * p[n] - p[n - 1]) / (x * x - 1);
      const double step = p[n] / slope;
      x -= step;
      if (std::abs(step) < 1e-16) break;
    }
    legendre_values(x, n + 1, p.data());
    slope = n * (x * p[n] - p[n - 1]) / (x * x - 1);
    node[g] = x;
    weight[g] = 2 / ((1 - x * x) * slope * slope);
    std::copy_n(p.begin(), n, legendre.begin() + g * n);
  }
}

const GaussRule& gauss_rule(int degree) {
  static const auto rules = [] {
    std::vector<GaussRule> r;
    for (int m = 0; m <= kMaxDegree; ++m) r.emplace_back(2 * m + 1);
    return r;
  }();
  return rules[degree];
}

}  // namespace knotfit
