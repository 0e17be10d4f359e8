#include "fit/knot_gain.h"

#include <algorithm>

namespace knotfit {
namespace {

/// Values of the functions alive on a span at local coordinate t, from their Legendre coefficients.
inline void span_values(const Axis& axis, Index s, double t, double* values) {
  const int w = axis.width();
  double p[2 * kMaxDegree + 2];
  legendre_values(t, w, p);
  const double* basis = axis.basis(s);
  for (int i = 0; i < w; ++i) values[i] = 0;
  for (int a = 0; a < w; ++a)
    for (int i = 0; i < w; ++i) values[i] += p[a] * basis[a * w + i];
}

}  // namespace

std::vector<double> knot_gains(const MovingFit& fitted, bool along_v) {
  const Axis& along = along_v ? fitted.axis_v() : fitted.axis_u();
  const Axis& across = along_v ? fitted.axis_u() : fitted.axis_v();
  const CellOrder& points = fitted.system().points();
  const std::vector<double>& residual = fitted.system().residual();
  const int m = along.degree(), reach = (m + 1) / 2 + 1, d = points.dimension();
  const Index spans = along.spans(), nj = across.functions();

  if (static_cast<Index>(residual.size()) != points.size() * d) {  // nothing was ever solved: the widest span
    std::vector<double> lengths(spans);
    for (Index s = 0; s < spans; ++s) lengths[s] = along.length(s);
    return lengths;
  }

  // The function centred on a knot added at the middle of span s, as Legendre coefficients on each span near
  // s; on s itself it has two halves, each in its own coordinate.
  const int w = m + 1, near = 2 * reach + 2;  // spans s - reach .. s + reach, and the second half of s
  std::vector<double> phi(spans * near * w, 0.0);
  const std::vector<double> interior = along.knots().interior();
  for (Index s = 0; s < spans; ++s) {
    if (along.length(s) <= 0) continue;
    std::vector<double> knots = interior;
    knots.insert(knots.begin() + s, along.low(s) + along.length(s) / 2);
    const Axis refined(m, knots);
    const Index centre = s + m + 1 - (m + 1) / 2;
    for (Index z = std::max<Index>(0, centre - m); z <= std::min(spans, centre); ++z) {
      const Index slot = (z <= s ? z - s + reach : z == s + 1 ? near - 1 : z - 1 - s + reach);
      for (int a = 0; a < w; ++a) phi[(s * near + slot) * w + a] = refined.basis(z)[a * w + centre - z];
    }
  }

  struct Sums {
    std::vector<double> numerator, denominator;  // spans x across functions (x components)
    Sums& operator+=(const Sums& o) {
      if (o.numerator.empty()) return *this;
      if (numerator.empty()) return *this = o;
      for (std::size_t i = 0; i < numerator.size(); ++i) numerator[i] += o.numerator[i];
      for (std::size_t i = 0; i < denominator.size(); ++i) denominator[i] += o.denominator[i];
      return *this;
    }
  };
  // A chunk's sums are as long as the net: chunks grow with it, so that adding them stays cheap.
  const Index chunk = std::max<Index>(kChunk, spans * nj * d);
  const Sums sums = parallel_sum<Sums>(
      points.size(),
      [&](Index begin, Index end) {
        Sums sum{std::vector<double>(spans * nj * d, 0.0), std::vector<double>(spans * nj, 0.0)};
        double b[kMaxDegree + 1], p[kMaxDegree + 1], half[kMaxDegree + 1];
        for (Index i = begin; i < end; ++i) {
          const double x = along_v ? points.stored_v(i) : points.stored_u(i);
          const double y = along_v ? points.stored_u(i) : points.stored_v(i);
          const Index sx = along.span(x), sy = across.span(y);
          const double t = along.local(sx, x);
          span_values(across, sy, across.local(sy, y), b);
          legendre_values(t, w, p);
          legendre_values(t < 0 ? 2 * t + 1 : 2 * t - 1, w, half);
          const double weight = points.weights().empty() ? 1.0 : points.weights()[i];
          for (Index s = std::max<Index>(0, sx - reach); s <= std::min(spans - 1, sx + reach); ++s) {
            const Index slot = s == sx && t >= 0 ? near - 1 : sx - s + reach;
            const double *c = phi.data() + (s * near + slot) * w, *q = s == sx ? half : p;
            double value = 0;
            for (int a = 0; a < w; ++a) value += c[a] * q[a];
            if (value == 0) continue;
            double* below = sum.denominator.data() + s * nj + sy;
            double* above = sum.numerator.data() + (s * nj + sy) * d;
            for (int j = 0; j <= across.degree(); ++j) {
              const double product = value * b[j];
              below[j] += weight * product * product;
              for (int e = 0; e < d; ++e) above[j * d + e] += weight * residual[i * d + e] * product;
            }
          }
        }
        return sum;
      },
      chunk);

  std::vector<double> gain(spans, 0.0);
  for (Index s = 0; s < spans; ++s)
    for (Index j = 0; j < nj; ++j) {
      const double below = sums.denominator[s * nj + j];
      if (!(below > 0)) continue;
      for (int e = 0; e < d; ++e) {
        const double a = sums.numerator[(s * nj + j) * d + e];
        gain[s] += a * a / below;
      }
    }
  return gain;
}

}  // namespace knotfit
