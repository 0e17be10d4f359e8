#include "nearest/surface_tree.h"

#include <algorithm>
#include <cmath>

#include "nearest/foot_points.h"
namespace knotfit {
namespace {

constexpr int kLeast = 2, kMost = 32;
/// Places tried for one point. Where there are more, the surface is equally near within the margin, as from the centre of
/// a sphere.
constexpr std::size_t kMostTries = 64;

/// Bernstein coefficients on [-1,1] of t^k: row j of (n + 1)^2.
std::vector<double> to_bernstein(int n) {
  // t = 2 x - 1, then x^k = sum_j C(j,k) / C(n,k) B_j(x).
  std::vector<double> binomial(static_cast<std::size_t>((n + 1) * (n + 1)), 0.0), matrix = binomial;
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= i; ++k)
      binomial[i * (n + 1) + k] =
          k == 0 || k == i ? 1 : binomial[(i - 1) * (n + 1) + k - 1] + binomial[(i - 1) * (n + 1) + k];
  for (int k = 0; k <= n; ++k)
    for (int i = 0; i <= k; ++i) {  // t^k = sum_i C(k,i) 2^i (-1)^(k-i) x^i
      const double c = binomial[k * (n + 1) + i] * std::ldexp((k - i) % 2 == 0 ? 1.0 : -1.0, i);
      for (int j = i; j <= n; ++j)
        matrix[j * (n + 1) + k] += c * binomial[j * (n + 1) + i] / binomial[n * (n + 1) + i];
    }
  return matrix;
}

/// Bounds of |S_tt|, |S_ts|, |S_ss| over t, s in [-1,1] from second differences of the Bezier points.
class SecondBounds {
 public:
  SecondBounds(int p, int q) : p_(p), q_(q), u_(to_bernstein(p)), v_(to_bernstein(q)) {}
  std::array<double, 3> operator()(const double* c) {
    const int wu = p_ + 1, wv = q_ + 1;
    half_.assign(static_cast<std::size_t>(wu * wv * 3), 0.0);
    points_.assign(half_.size(), 0.0);
    for (int k = 0; k < wu; ++k)
      for (int j = 0; j < wv; ++j)
        for (int l = 0; l < wv; ++l)
          for (int d = 0; d < 3; ++d) half_[(k * wv + j) * 3 + d] += v_[j * wv + l] * c[(k * wv + l) * 3 + d];
    for (int i = 0; i < wu; ++i)
      for (int k = 0; k < wu; ++k)
        for (int x = 0; x < wv * 3; ++x) points_[i * wv * 3 + x] += u_[i * wu + k] * half_[k * wv * 3 + x];
    const auto b = [&](int i, int j) { return at(&points_[(i * wv + j) * 3]); };
    std::array<double, 3> most{};
    for (int i = 0; i < wu; ++i)
      for (int j = 0; j < wv; ++j) {
        if (i + 2 < wu) most[0] = std::max(most[0], squared(b(i + 2, j) - 2 * b(i + 1, j) + b(i, j)));
        if (j + 2 < wv) most[2] = std::max(most[2], squared(b(i, j + 2) - 2 * b(i, j + 1) + b(i, j)));
        if (i + 1 < wu && j + 1 < wv)
          most[1] = std::max(most[1], squared(b(i + 1, j + 1) - b(i + 1, j) - b(i, j + 1) + b(i, j)));
      }
    // d/dt is half of d/dx.
    return {p_ * (p_ - 1) / 4.0 * std::sqrt(most[0]), p_ * q_ / 4.0 * std::sqrt(most[1]),
            q_ * (q_ - 1) / 4.0 * std::sqrt(most[2])};
  }

 private:
  int p_, q_;
  std::vector<double> u_, v_, half_, points_;
};

/// |S - T| <= (a^2 M_tt + 2 a b M_ts + b^2 M_ss) / 8 on a triangle with legs a, b [Filip86].
double deviation(const std::array<double, 3>& m, int nu, int nv) {
  const double a = 2.0 / nu, b = 2.0 / nv;
  return (a * a * m[0] + 2 * a * b * m[1] + b * b * m[2]) / 8;
}

}  // namespace

SurfaceTree::SurfaceTree(const CellPolynomials& surface) : surface_(surface) {
  const SpanTable &tu = surface.u(), &tv = surface.v();
  const int p = tu.degree(), q = tv.degree();
  double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
  for (Index a = 0; a < tu.spans(); ++a)
    for (Index b = 0; b < tv.spans(); ++b) {
      const Vec3 s = surface.jet(tu.low(a) + tu.length(a) / 2, tv.low(b) + tv.length(b) / 2).s;
      const double x[3] = {s.x, s.y, s.z};
      for (int d = 0; d < 3; ++d) low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
    }
  const double aim = 1e-4 * std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);

  SecondBounds second_bounds(p, q);
  std::vector<double> vertices;
  std::vector<std::array<std::int32_t, 3>> faces;
  for (Index a = 0; a < tu.spans(); ++a)
    for (Index b = 0; b < tv.spans(); ++b) {
      const double* c = surface.coefficients(a * tv.spans() + b);
      const std::array<double, 3> m = second_bounds(c);
      int nu = kLeast, nv = kLeast;
      while (deviation(m, nu, nv) > aim && std::min(nu, nv) < kMost) {
        const bool more_u = m[0] / (nu * nu) >= m[2] / (nv * nv);
        if ((more_u && nu < kMost) || nv >= kMost)
          nu *= 2;
        else
          nv *= 2;
      }
      const double margin = deviation(m, nu, nv);
      margin_ = std::max(margin_, margin);
      const auto first = static_cast<std::int32_t>(vertices.size() / 3);
      const auto place_u = [&](int i) {
        return i == nu ? tu.low(a) + tu.length(a) : tu.low(a) + tu.length(a) * i / nu;
      };
      const auto place_v = [&](int j) {
        return j == nv ? tv.low(b) + tv.length(b) : tv.low(b) + tv.length(b) * j / nv;
      };
      for (int i = 0; i <= nu; ++i)
        for (int j = 0; j <= nv; ++j) {
          // The surface may jump at the cell's far sides: its own polynomial counts there too.
          const double t = -1 + 2.0 * i / nu, s = -1 + 2.0 * j / nv;
          double value[3] = {};
          for (int k = p; k >= 0; --k) {
            double inner[3] = {};
            for (int l = q; l >= 0; --l)
              for (int d = 0; d < 3; ++d) inner[d] = inner[d] * s + c[(k * (q + 1) + l) * 3 + d];
            for (int d = 0; d < 3; ++d) value[d] = value[d] * t + inner[d];
          }
          vertices.insert(vertices.end(), value, value + 3);
          if (i == nu || j == nv) continue;
          const std::int32_t k = first + i * (nv + 1) + j;
          faces.push_back({k, k + nv + 1, k + nv + 2});
          faces.push_back({k, k + nv + 2, k + 1});
          patches_.push_back({place_u(i), place_u(i + 1), place_v(j), place_v(j + 1), a, b, margin});
        }
    }
  tree_.emplace(vertices, faces);
}

SurfaceTree::Closest SurfaceTree::closest(const Vec3& p, const double* start) const {
  Closest best;
  best.squared = INFINITY;
  Index best_u = -1, best_v = -1;
  const auto look = [&](Index a, Index b, double u, double v) {
    double uv[2] = {u, v};
    const double d = polish_in_cell(surface_, a, b, p, uv);
    if (!(d < best.squared)) return;
    best = {uv[0], uv[1], d};
    best_u = a, best_v = b;
  };
  const auto from = [&](const TriangleHit& hit) {
    const Patch& r = patches_[hit.face / 2];
    const std::array<double, 3>& w = hit.weight;
    // Corners: (0,0) (1,0) (1,1), or (0,0) (1,1) (0,1).
    const double x = hit.face % 2 == 0 ? w[1] + w[2] : w[1], y = hit.face % 2 == 0 ? w[2] : w[1] + w[2];
    look(r.span_u, r.span_v, r.u0 + x * (r.u1 - r.u0), r.v0 + y * (r.v1 - r.v0));
  };
  if (start != nullptr) {
    double uv[2] = {start[0], start[1]};
    polish(surface_, p, uv);
    look(surface_.u().span(uv[0]), surface_.v().span(uv[1]), uv[0], uv[1]);
  } else {
    from(tree_->nearest(p));
  }
  // Looks at all other places where the surface may be nearer, the nearest triangles first.
  struct Try {
    double distance;
    Index face;
  };
  std::vector<Try> tries;
  double distance = std::sqrt(best.squared);
  const auto may_be_nearer = [&](const Try& t) {
    return t.distance - patches_[t.face / 2].margin < distance * (1 - 1e-9);
  };
  const auto collect = [&] {
    tries.clear();
    tree_->within(
        p, [&] { return distance + margin_; },
        [&](Index face, double squared_distance) {
          const Try t{std::sqrt(squared_distance), face};
          if (may_be_nearer(t)) tries.push_back(t);
        });
  };
  collect();
  if (start != nullptr && tries.size() > kMostTries) {  // the start was far from the closest point
    from(tree_->nearest(p));
    distance = std::sqrt(best.squared);
    collect();
  }
  std::sort(tries.begin(), tries.end(), [](const Try& a, const Try& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.face < b.face);
  });
  std::size_t tried = 0;
  for (const Try& t : tries) {
    if (tried == kMostTries) break;
    const Patch& r = patches_[t.face / 2];
    // The search on the best's own patch ended at the best.
    if (!may_be_nearer(t) || (r.span_u == best_u && r.span_v == best_v && best.u >= r.u0 && best.u <= r.u1 &&
                              best.v >= r.v0 && best.v <= r.v1))
      continue;
    ++tried;
    look(r.span_u, r.span_v, (r.u0 + r.u1) / 2, (r.v0 + r.v1) / 2);
    distance = std::sqrt(best.squared);
  }
  return best;
}

}  // namespace knotfit
