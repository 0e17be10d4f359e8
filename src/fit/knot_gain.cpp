#include "fit/knot_gain.h"

#include <algorithm>

#include "fit/scattered.h"
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

std::vector<double> knot_gains(FitProblem& fitted, bool along_v) {
  const Axis& along = along_v ? fitted.axis_v() : fitted.axis_u();
  const Axis& across = along_v ? fitted.axis_u() : fitted.axis_v();
  const CellOrder& points = fitted.scattered().points();
  const std::vector<double>& residual = fitted.scattered().residual();
  const int m = along.degree(), reach = (m + 1) / 2 + 1, d = points.dimension();
  const Index spans = along.spans(), nj = across.functions();

  if (static_cast<Index>(residual.size()) != points.size() * d) {  // nothing was ever solved: the widest span
    std::vector<double> lengths(spans);
    for (Index s = 0; s < spans; ++s) lengths[s] = along.length(s);
    return lengths;
  }

  // The axis with a knot added at the middle of span s, and the function centred on it.
  const std::vector<double> interior = along.knots().interior();
  std::vector<Axis> refined;
  std::vector<double> middle(spans);
  refined.reserve(spans);
  for (Index s = 0; s < spans; ++s) {
    middle[s] = along.low(s) + along.length(s) / 2;
    std::vector<double> knots = interior;
    if (along.length(s) > 0) knots.insert(knots.begin() + s, middle[s]);
    refined.emplace_back(m, knots);
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
        double b[kMaxDegree + 1], phi[kMaxDegree + 1];
        for (Index i = begin; i < end; ++i) {
          const double x = along_v ? points.stored_v(i) : points.stored_u(i);
          const double y = along_v ? points.stored_u(i) : points.stored_v(i);
          const Index sx = along.span(x), sy = across.span(y);
          span_values(across, sy, across.local(sy, y), b);
          const double w = points.weights().empty() ? 1.0 : points.weights()[i];
          for (Index s = std::max<Index>(0, sx - reach); s <= std::min(spans - 1, sx + reach); ++s) {
            if (along.length(s) <= 0) continue;
            const Axis& axis = refined[s];
            const Index centre = s + m + 1 - (m + 1) / 2;
            const Index z = axis.span(x), local = centre - z;
            if (local < 0 || local > m) continue;
            span_values(axis, z, axis.local(z, x), phi);
            for (int j = 0; j <= across.degree(); ++j) {
              const double q = phi[local] * b[j];
              const Index at = s * nj + sy + j;
              sum.denominator[at] += w * q * q;
              for (int e = 0; e < d; ++e) sum.numerator[at * d + e] += w * residual[i * d + e] * q;
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
