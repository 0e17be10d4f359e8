#include "nearest/cell_polynomials.h"

#include <array>
#include <cmath>
#include <cstring>

#include "base/clones.h"
#include "base/counting_sort.h"
#include "base/narrow.h"
#include "base/parallel.h"
#include "knotfit/basis.h"
#include "spline/basis_lanes.h"

namespace knotfit {

SpanTable::SpanTable(const KnotVector& knots) : degree_(knots.degree()), breaks_(knots.breaks()) {
  const int w = degree_ + 1;
  const Index n = spans();
  std::vector<double> rows(static_cast<std::size_t>(w * w));
  for (Index s = 0; s < n; ++s) {
    const double half = (breaks_[s + 1] - breaks_[s]) / 2, middle = breaks_[s] + half;
    const Index span = knots.find_span(middle);
    middle_.push_back(middle);
    inverse_half_.push_back(1 / half);
    function_.push_back(span - degree_);
    basis_derivatives(knots, span, middle, degree_, rows);
    double scale = 1;  // half^k / k!
    for (int k = 0; k < w; ++k) {
      for (int a = 0; a < w; ++a) powers_.push_back(rows[k * w + a] * scale);
      scale *= half / (k + 1);
    }
  }
  const Index buckets = 2 * n;
  per_length_ = static_cast<double>(buckets) / (last() - first());
  bucket_.assign(static_cast<std::size_t>(buckets + 2), 0);
  Index s = 0;
  for (Index b = 0; b < buckets + 2; ++b) {  // a little early: the product may round up across a bucket's end
    const double x = first() + (static_cast<double>(b) - 1e-9) / per_length_;
    while (s + 1 < n && x >= breaks_[s + 1]) ++s;
    bucket_[b] = s;
  }
}

CellPolynomials::CellPolynomials(const Surface& s)
    : u_(s.knots_u()), v_(s.knots_v()), stride_(Index{s.degree_u() + 1} * (s.degree_v() + 1) * 3) {
  const int wu = s.degree_u() + 1, wv = s.degree_v() + 1;
  coefficients_.assign(static_cast<std::size_t>(cells() * stride_), 0.0);
  parallel_for(u_.spans(), [&](Index su) {
    std::vector<double> half(static_cast<std::size_t>(wu * wv * 3));
    for (Index sv = 0; sv < v_.spans(); ++sv) {
      const double *pu = u_.powers(su), *pv = v_.powers(sv);
      std::fill(half.begin(), half.end(), 0.0);
      for (int a = 0; a < wu; ++a)
        for (int b = 0; b < wv; ++b) {
          const double* c = s.control_point(u_.function(su) + a, v_.function(sv) + b).data();
          for (int l = 0; l < wv; ++l)
            for (int d = 0; d < 3; ++d) half[(a * wv + l) * 3 + d] += pv[l * wv + b] * c[d];
        }
      double* out = coefficients_.data() + (su * v_.spans() + sv) * stride_;
      for (int k = 0; k < wu; ++k)
        for (int a = 0; a < wu; ++a)
          for (int x = 0; x < 3 * wv; ++x) out[k * wv * 3 + x] += pu[k * wu + a] * half[a * wv * 3 + x];
    }
  });
}

namespace {

/// Horner in v inside, in u outside. \param out  S, S_t, S_s: nine T
template <class T>
KNOTFIT_INLINE void horner(const double* c, int p, int q, const T& t, const T& s, T* out) {
  T value[3] = {}, by_u[3] = {}, by_v[3] = {};
  for (int k = p; k >= 0; --k) {
    const double* row = c + k * (q + 1) * 3;
    T inner[3] = {}, slope[3] = {};
    for (int d = 0; d < 3; ++d) inner[d] = T{} + row[q * 3 + d];
    for (int l = q - 1; l >= 0; --l)
      for (int d = 0; d < 3; ++d) {
        slope[d] = slope[d] * s + inner[d];
        inner[d] = inner[d] * s + row[l * 3 + d];
      }
    for (int d = 0; d < 3; ++d) {
      if (k == p) {
        value[d] = inner[d];
        by_v[d] = slope[d];
      } else {
        by_u[d] = by_u[d] * t + value[d];
        value[d] = value[d] * t + inner[d];
        by_v[d] = by_v[d] * t + slope[d];
      }
    }
  }
  for (int d = 0; d < 3; ++d) {
    out[d] = value[d];
    out[3 + d] = by_u[d];
    out[6 + d] = by_v[d];
  }
}

/// kLanes places of one cell. \param out  9 x kLanes
KNOTFIT_CLONES void horner_lanes(const double* c, int p, int q, const double* t, const double* s,
                                 double* out) {
  Lanes x, y, r[9];
  std::memcpy(&x, t, sizeof x);
  std::memcpy(&y, s, sizeof y);
  if (p == 3 && q == 3)
    horner<Lanes>(c, 3, 3, x, y, r);
  else
    horner<Lanes>(c, p, q, x, y, r);
  std::memcpy(out, r, sizeof r);
}

/// \param r  nine numbers, `step` apart
Jet to_jet(const double* r, int step, double scale_u, double scale_v) {
  return {{r[0], r[step], r[2 * step]},
          {r[3 * step] * scale_u, r[4 * step] * scale_u, r[5 * step] * scale_u},
          {r[6 * step] * scale_v, r[7 * step] * scale_v, r[8 * step] * scale_v}};
}

}  // namespace

Jet CellPolynomials::jet(double u, double v) const {
  const Index a = u_.span(u), b = v_.span(v);
  double r[9];
  horner<double>(coefficients(a * v_.spans() + b), u_.degree(), v_.degree(), u_.local(a, u), v_.local(b, v),
                 r);
  return to_jet(r, 1, u_.inverse_half(a), v_.inverse_half(b));
}

Jet CellPolynomials::jet(double u, double v, SecondDerivatives& second) const {
  return jet(u_.span(u), v_.span(v), u, v, second);
}

Jet CellPolynomials::jet(Index a, Index b, double u, double v, SecondDerivatives& second) const {
  const double t = u_.local(a, u), s = v_.local(b, v), hu = u_.inverse_half(a), hv = v_.inverse_half(b);
  const double* c = coefficients(a * v_.spans() + b);
  const int p = u_.degree(), q = v_.degree();
  // Horner's scheme for the value and its Taylor coefficients: f[i][j] is d^i/dt^i d^j/ds^j S / (i! j!).
  double f[3][3][3] = {};
  for (int k = p; k >= 0; --k) {
    double g[3][3] = {};
    for (int l = q; l >= 0; --l)
      for (int d = 0; d < 3; ++d) {
        g[2][d] = g[2][d] * s + g[1][d];
        g[1][d] = g[1][d] * s + g[0][d];
        g[0][d] = g[0][d] * s + c[(k * (q + 1) + l) * 3 + d];
      }
    for (int j = 0; j < 3; ++j)
      for (int d = 0; d < 3; ++d) {
        f[2][j][d] = f[2][j][d] * t + f[1][j][d];
        f[1][j][d] = f[1][j][d] * t + f[0][j][d];
        f[0][j][d] = f[0][j][d] * t + g[j][d];
      }
  }
  const auto vec = [&](int i, int j, double scale) {
    return scale * Vec3{f[i][j][0], f[i][j][1], f[i][j][2]};
  };
  second = {vec(2, 0, 2 * hu * hu), vec(1, 1, hu * hv), vec(0, 2, 2 * hv * hv)};
  return {vec(0, 0, 1), vec(1, 0, hu), vec(0, 1, hv)};
}

void CellPolynomials::jets(std::span<const double> uv, Jet* out) const {
  const Index n = static_cast<Index>(uv.size() / 2);
  const int p = u_.degree(), q = v_.degree();
  double t[kLanes], s[kLanes], r[9 * kLanes];
  Index k = 0;
  Index a = 0, b = 0, a_next = 0, b_next = 0;
  if (n > 0) a_next = u_.span(uv[0]), b_next = v_.span(uv[1]);
  while (k < n) {
    a = a_next, b = b_next;
    Index end = k;
    while (end < n && end - k < kLanes && a_next == a && b_next == b) {
      t[end - k] = u_.local(a, uv[2 * end]);
      s[end - k] = v_.local(b, uv[2 * end + 1]);
      ++end;
      if (end < n) a_next = u_.span(uv[2 * end]), b_next = v_.span(uv[2 * end + 1]);
    }
    const int count = static_cast<int>(end - k);
    const double* c = coefficients(a * v_.spans() + b);
    const double hu = u_.inverse_half(a), hv = v_.inverse_half(b);
    if (count < 3) {
      for (int l = 0; l < count; ++l) {
        horner<double>(c, p, q, t[l], s[l], r);
        out[k + l] = to_jet(r, 1, hu, hv);
      }
    } else {
      for (int l = count; l < kLanes; ++l) t[l] = t[count - 1], s[l] = s[count - 1];
      horner_lanes(c, p, q, t, s, r);
      for (int l = 0; l < count; ++l) out[k + l] = to_jet(r + l, kLanes, hu, hv);
    }
    k = end;
  }
}

std::vector<std::int32_t> order_by_cell(const CellPolynomials& surface, std::span<const double> uv) {
  const Index n = static_cast<Index>(uv.size() / 2);
  narrow(n);
  std::vector<std::int32_t> cell(static_cast<std::size_t>(n)), order;
  for (Index k = 0; k < n; ++k) cell[k] = static_cast<std::int32_t>(surface.cell(uv[2 * k], uv[2 * k + 1]));
  counting_sort(cell, surface.cells(), order);
  return order;
}

}  // namespace knotfit
