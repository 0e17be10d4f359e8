#include "solve/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "knotfit/basis.h"
#include "solve/gauss_rule.h"
namespace knotfit {

namespace {

/// p_j = p_{j mod n} + j div n, from -degree to n + degree.
KnotVector running_on(int degree, std::span<const double> period) {
  const Index n = static_cast<Index>(period.size());
  std::vector<double> knots;
  for (Index j = 0; j <= n + 2 * degree; ++j) {
    const Index i = j - degree, turn = (i >= 0 ? i : i - n + 1) / n;
    knots.push_back(period[i - turn * n] + static_cast<double>(turn));
  }
  return KnotVector(degree, std::move(knots));
}

}  // namespace

Axis::Axis(int degree, std::span<const double> interior)
    : Axis(KnotVector::clamped(degree, interior), static_cast<Index>(interior.size()) + 1, false) {}

Axis Axis::periodic(int degree, std::span<const double> period) {
  return Axis(running_on(degree, period), static_cast<Index>(period.size()), true);
}

Axis::Axis(KnotVector knots, Index spans, bool periodic)
    : degree_(knots.degree()),
      knots_(std::move(knots)),
      spans_(spans),
      periodic_(periodic),
      first_(knots_.first()) {
  low_.resize(spans_);
  upper_.resize(spans_);
  scale_.resize(spans_);
  Index last = 0;
  for (Index s = 0; s < spans_; ++s) {
    low_[s] = low(s);
    upper_[s] = knots_[s + degree_ + 1];  // not low + length, which may round to another number
    scale_[s] = length(s) > 0 ? 2 / length(s) : 0;
    if (length(s) > 0) last = s;
  }
  for (Index s = last; s < spans_; ++s) upper_[s] = std::numeric_limits<double>::infinity();

  // A bucket's entry is the first span that reaches past the bucket's lower end.
  buckets_ = static_cast<int>(std::clamp<Index>(2 * spans_, 16, 4096));
  bucket_.resize(buckets_ + 1);
  Index s = 0;
  for (int b = 0; b <= buckets_; ++b) {
    // One bucket early: x * buckets_ may round up across a boundary.
    const double x = first_ + (b - 1e-9) / buckets_;
    while (x >= upper_[s]) ++s;
    bucket_[b] = s;
  }

  const int w = width(), q = moments(), np = pairs();
  const GaussRule& rule = gauss_rule(degree_);
  basis_.assign(spans_ * w * w, 0);
  products_.assign(spans_ * np * q, 0);
  std::vector<double> b(w);
  for (Index k = 0; k < spans_; ++k) {
    if (length(k) <= 0) continue;
    double* basis = basis_.data() + k * w * w;
    double* products = products_.data() + k * np * q;
    for (int g = 0; g < q; ++g) {  // q nodes are exact to degree 4 m + 1: products times P_{2m}
      const double x = low(k) + length(k) * (rule.node[g] + 1) / 2;
      basis_functions(knots_, k + degree_, x, b);
      const double* p = rule.legendre.data() + g * q;
      for (int a = 0; a < w; ++a)
        for (int i = 0; i < w; ++i) basis[a * w + i] += (a + 0.5) * rule.weight[g] * p[a] * b[i];
      int row = 0;
      for (int i = 0; i < w; ++i)
        for (int i2 = 0; i2 <= i; ++i2, ++row)
          for (int a = 0; a < q; ++a)
            products[row * q + a] += (a + 0.5) * rule.weight[g] * p[a] * b[i] * b[i2];
    }
  }
}

std::vector<double> Axis::gram(int derivative) const {
  const int w = width();
  std::vector<double> result(functions() * w, 0.0), c(w * w);
  for (Index s = 0; s < spans_; ++s) {
    if (length(s) <= 0) continue;
    std::copy_n(basis(s), w * w, c.begin());
    // P_a' = (2a-1) P_{a-1} + (2a-5) P_{a-3} + ... [Abramowitz64 8.5.4]: from the top, row b of the derivative
    // is (2b+1) times the sum of the rows b+1, b+3, ...
    for (int r = 0; r < derivative; ++r)
      for (int i = 0; i < w; ++i) {
        double even = 0, odd = 0;
        for (int a = w - 1; a >= 0; --a) {
          double& above = a % 2 == 0 ? odd : even;
          (a % 2 == 0 ? even : odd) += c[a * w + i];
          c[a * w + i] = (2 * a + 1) * scale_[s] * above;
        }
      }
    for (int a = 0; a < w; ++a) {
      const double norm = length(s) / (2 * a + 1);  // int P_a^2 over the span
      for (int i = 0; i < w; ++i)
        for (int k = 0; k <= i; ++k) result[function(s, i) * w + k] += norm * c[a * w + i] * c[a * w + i - k];
    }
  }
  return result;
}

}  // namespace knotfit
