#include "correct/map_hold.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
namespace knotfit::correction {

std::vector<GradientDatum> gradient_data(const HoldingMesh& mesh, const SpanTable& u, const SpanTable& v,
                                         double eps) {
  constexpr int per_span = 3;
  std::vector<GradientDatum> data;
  if (!(eps > 0)) return data;
  const MapView map = mesh.view();
  const MapSamples grid = sample_map(map, centred_places(u, per_span), centred_places(v, per_span));
  const Index nu = static_cast<Index>(grid.u.size()), nv = static_cast<Index>(grid.v.size());
  const double each = eps / static_cast<double>(nu * nv);
  for (Index i = 0; i < nu; ++i)
    for (Index j = 0; j < nv; ++j) {
      const std::int32_t f = grid.face[grid.index(i, j)];
      if (f < 0 || !map.is_data(f)) continue;
      const double hu = u.length(i / per_span), hv = v.length(j / per_span);
      const double w = each * hu * hv / (u.mean_length() * v.mean_length());
      const TriangleFrame t = triangle_frame(map, f);
      data.push_back({grid.u[i], grid.v[j], w * hu * hu, w * hv * hv, t.xu, t.xv});
    }
  for (const auto& [a, b] : mesh.border) {
    const double *p = &mesh.uv[2 * a], *q = &mesh.uv[2 * b];
    for (const int c : {0, 1}) {  // the edge runs along coordinate c; the other one is 0 or 1
      const double side = p[1 - c], from = std::min(p[c], q[c]), to = std::max(p[c], q[c]);
      if (side != q[1 - c] || (side != 0 && side != 1) || to - from < 1e-12) continue;
      const std::vector<double>& places = c == 0 ? grid.u : grid.v;
      const SpanTable& spans = c == 0 ? u : v;
      const Vec3 slope = (1 / (q[c] - p[c])) * (mesh.position[b] - mesh.position[a]);
      for (auto at = std::lower_bound(places.begin(), places.end(), from); at != places.end() && *at <= to;
           ++at) {
        const double h = spans.length((at - places.begin()) / per_span);
        const double w = 0.25 * eps / static_cast<double>(places.size()) * h / spans.mean_length() * h * h;
        data.push_back(c == 0 ? GradientDatum{*at, side, w, 0, slope, {}}
                              : GradientDatum{side, *at, 0, w, {}, slope});
      }
    }
  }
  return data;
}

namespace {

/// A = R(phi) diag(s1, s2) R(theta), R rotations, s1 >= |s2|, the sign of s2 that of det A.
struct SignedSingularValues {
  double e, f, g, h, s1, s2;
  explicit SignedSingularValues(const double* a)
      : e((a[0] + a[3]) / 2), f((a[0] - a[3]) / 2), g((a[2] + a[1]) / 2), h((a[2] - a[1]) / 2) {
    const double q = std::sqrt(e * e + h * h), r = std::sqrt(f * f + g * g);
    s1 = q + r;
    s2 = q - r;
  }
  double phi() const { return (std::atan2(h, e) + std::atan2(g, f)) / 2; }
  double theta() const { return (std::atan2(h, e) - std::atan2(g, f)) / 2; }
};

/// The centres of windows that reach `reach` places to both sides, clipped.
std::vector<double> window_centres(const std::vector<double>& places, Index reach) {
  std::vector<double> centres;
  const auto n = static_cast<Index>(places.size());
  for (Index k = 0; k < n; ++k) {
    const Index from = std::max<Index>(0, k - reach), to = std::min(n - 1, k + reach);
    double sum = 0;
    for (Index i = from; i <= to; ++i) sum += places[i];
    centres.push_back(sum / static_cast<double>(to - from + 1));
  }
  return centres;
}

}  // namespace

Reference reference(const HoldingMesh& mesh, const SpanTable& u, const SpanTable& v, double aspect) {
  constexpr double floor = 0.3;  // of singular values, in units of the mean
  const MapView map = mesh.view();
  Reference r;
  r.grid = sample_map(map, centred_places(u, kReferencePerSpan), centred_places(v, kReferencePerSpan));
  const Index nu = static_cast<Index>(r.grid.u.size()), nv = static_cast<Index>(r.grid.v.size()), n = nu * nv;
  std::vector<double> rows(static_cast<std::size_t>(9 * n), 0.0), areas(static_cast<std::size_t>(n), 0.0);
  std::vector<char> use(static_cast<std::size_t>(n), 0);
  parallel_for(nu, [&](Index i) {
    for (Index q = i * nv; q < (i + 1) * nv; ++q) {
      const std::int32_t f = r.grid.face[q];
      if (f < 0 || !map.is_data(f)) continue;
      const TriangleFrame t = triangle_frame(map, f);
      const double row[9] = {t.normal.x, t.normal.y, t.normal.z, t.xu.x, t.xu.y,
                             t.xu.z,     t.xv.x,     t.xv.y,     t.xv.z};
      std::copy_n(row, 9, &rows[9 * q]);
      areas[q] = length(cross(t.xu, t.xv));
      use[q] = 1;
    }
  });
  double sum = 0, count = 0;
  for (Index q = 0; q < n; ++q)
    if (use[q]) sum += areas[q], count += 1;
  r.mean_area = count > 0 ? sum / count : 0;
  const std::vector<double> means = window_means(rows, 9, use, nu, nv, kReferencePerSpan / 2);
  const double least = floor * std::sqrt(r.mean_area), au = std::sqrt(aspect), av = 1 / au;
  r.samples.resize(static_cast<std::size_t>(n));
  parallel_for(nu, [&](Index i) {
    for (Index q = i * nv; q < (i + 1) * nv; ++q) {
      Reference::Sample& s = r.samples[q];
      const Vec3 mean = at(&means[9 * q]), xu = at(&means[9 * q + 3]), xv = at(&means[9 * q + 6]);
      if (!use[q] || length(mean) < 1e-6) continue;
      s.n = unit(mean);
      s.xu = xu, s.xv = xv;
      Vec3 x = xu - dot(s.n, xu) * s.n;
      if (length(x) < 1e-12) x = cross(xv, s.n);
      if (length(x) < 1e-12) continue;
      s.used = true;
      s.t1 = unit(x);
      s.t2 = cross(s.n, s.t1);
      // J = Q diag(s) R of [X_u X_v] diag(1/au, 1/av) in the frame; K = diag(1/au, 1/av) R^T diag(1/s) Q^T.
      const double j[4] = {dot(s.t1, xu) / au, dot(s.t1, xv) / av, dot(s.t2, xu) / au, dot(s.t2, xv) / av};
      const SignedSingularValues svd(j);
      const double s1 = std::max(svd.s1, least), s2 = std::max(svd.s2, least);
      const double cq = std::cos(svd.phi()), sq = std::sin(svd.phi()), cr = std::cos(svd.theta()),
                   sr = std::sin(svd.theta());
      // R = [cr -sr; sr cr], Q = [cq -sq; sq cq]
      s.k[0] = (cr * cq / s1 - sr * sq / s2) / au;
      s.k[1] = (cr * sq / s1 + sr * cq / s2) / au;
      s.k[2] = (-sr * cq / s1 - cr * sq / s2) / av;
      s.k[3] = (-sr * sq / s1 + cr * cq / s2) / av;
    }
  });
  r.centre_u = window_centres(r.grid.u, kReferencePerSpan / 2);
  r.centre_v = window_centres(r.grid.v, kReferencePerSpan / 2);
  return r;
}

std::optional<std::array<double, 3>> curvature_at(const Reference& r, Index i, Index j) {
  constexpr Index reach = kReferencePerSpan / 2;
  const Index nu = static_cast<Index>(r.grid.u.size()), nv = static_cast<Index>(r.grid.v.size());
  const Index i0 = std::max<Index>(0, i - reach), i1 = std::min(nu - 1, i + reach),
              j0 = std::max<Index>(0, j - reach), j1 = std::min(nv - 1, j + reach);
  const Reference::Sample &s = r.samples[i * nv + j], &u0 = r.samples[i0 * nv + j],
                          &u1 = r.samples[i1 * nv + j], &v0 = r.samples[i * nv + j0],
                          &v1 = r.samples[i * nv + j1];
  if (!s.used || !u0.used || !u1.used || !v0.used || !v1.used) return std::nullopt;
  const Vec3 n_u = 1 / (r.centre_u[i1] - r.centre_u[i0]) * (u1.n - u0.n),
             n_v = 1 / (r.centre_v[j1] - r.centre_v[j0]) * (v1.n - v0.n);
  return std::array{-dot(n_u, s.xu), -0.5 * (dot(n_u, s.xv) + dot(n_v, s.xu)), -dot(n_v, s.xv)};
}

namespace {

/// 0 where the angle between the surface's normal and the blurred mesh's is free, 1 where it is charged in full.
double ruffled(const Jet& jet, const Vec3& n) {
  constexpr double free = std::numbers::pi / 12, full = 5 * std::numbers::pi / 36;  // 15 and 25 degrees
  const double angle = std::acos(std::clamp(dot(unit(cross(jet.u, jet.v)), n), -1.0, 1.0));
  return std::clamp((angle - free) / (full - free), 0.0, 1.0);
}

}  // namespace

HingeState hinge_rows(const CellPolynomials& surface, const Reference& ref,
                      const std::vector<double>& weights, double fairness) {
  constexpr double least = 0.5, most = 2, weight = 3e-2;
  constexpr int g = kReferencePerSpan;
  const SpanTable &tu = surface.u(), &tv = surface.v();
  const Index nv = static_cast<Index>(ref.grid.v.size());
  const double whole = (tu.last() - tu.first()) * (tv.last() - tv.first());
  const double cell_area = ref.mean_area / static_cast<double>(surface.cells());
  struct Row {
    double folded = 0, all = 0;
    std::vector<HingeRow> rows;
    std::vector<CurvatureDatum> curvature;
  };
  std::vector<Row> parts(static_cast<std::size_t>(tu.spans()));
  HingeState state;
  state.cell_folds.assign(static_cast<std::size_t>(surface.cells()), 0);
  parallel_for(tu.spans(), [&](Index a) {
    double uv[2 * g * g];
    Jet jets[g * g];
    for (Index b = 0; b < tv.spans(); ++b) {
      for (int x = 0; x < g * g; ++x)
        uv[2 * x] = ref.grid.u[a * g + x / g], uv[2 * x + 1] = ref.grid.v[b * g + x % g];
      surface.jets(uv, jets);
      const Index cell = a * tv.spans() + b;
      const double area = tu.length(a) * tv.length(b);
      for (int x = 0; x < g * g; ++x) {
        const Reference::Sample& s = ref.samples[(a * g + x / g) * nv + b * g + x % g];
        if (!s.used) continue;
        const Jet& jet = jets[x];
        parts[a].all += area;
        if (dot(cross(jet.u, jet.v), s.n) < 0) {
          parts[a].folded += area;
          state.cell_folds[cell] = 1;
        }
        if (weights.empty()) continue;
        const double off = fairness > 0 ? ruffled(jet, s.n) : 0;
        if (const auto target = off > 0 ? curvature_at(ref, a * g + x / g, b * g + x % g) : std::nullopt) {
          const double hu = tu.length(a) * tu.length(a), hv = tv.length(b) * tv.length(b),
                       w = fairness * off * area / (whole * g * g);
          parts[a].curvature.push_back(
              {uv[2 * x], uv[2 * x + 1], s.n, {w * hu * hu, 2 * w * hu * hv, w * hv * hv}, *target});
        }
        const double j[4] = {dot(s.t1, jet.u), dot(s.t1, jet.v), dot(s.t2, jet.u), dot(s.t2, jet.v)};
        const double m[4] = {j[0] * s.k[0] + j[1] * s.k[2], j[0] * s.k[1] + j[1] * s.k[3],
                             j[2] * s.k[0] + j[3] * s.k[2], j[2] * s.k[1] + j[3] * s.k[3]};
        const SignedSingularValues svd(m);
        if (svd.s2 >= least && svd.s1 <= most) continue;
        const double cy = std::cos(svd.phi()), sy = std::sin(svd.phi()), cz = std::cos(svd.theta()),
                     sz = std::sin(svd.theta());
        const double w = weight * weights[cell] * cell_area * area / (g * g);
        const auto add = [&](double y1, double y2, double z1, double z2, double target) {
          parts[a].rows.push_back({uv[2 * x], uv[2 * x + 1], s.k[0] * z1 + s.k[1] * z2,
                                   s.k[2] * z1 + s.k[3] * z2, y1 * s.t1 + y2 * s.t2, target, w});
        };
        // Y = [cy -sy; sy cy], Z^T = [cz -sz; sz cz].
        if (svd.s2 < least) add(-sy, cy, sz, cz, least);
        if (svd.s1 > most) add(cy, sy, cz, -sz, most);
      }
    }
  });
  double all = 0;
  for (Row& part : parts) {
    state.folded += part.folded;
    all += part.all;
    state.rows.insert(state.rows.end(), part.rows.begin(), part.rows.end());
    state.curvature.insert(state.curvature.end(), part.curvature.begin(), part.curvature.end());
  }
  if (all > 0) state.folded /= all;
  return state;
}

}  // namespace knotfit::correction
