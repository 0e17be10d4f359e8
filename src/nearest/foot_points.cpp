#include "nearest/foot_points.h"

#include <array>
#include <cmath>
#include <memory>

#include "base/parallel.h"
namespace knotfit {
namespace {

struct Domain {
  double u0, u1, v0, v1, width_u, width_v;
  explicit Domain(const CellPolynomials& s)
      : u0(s.u().first()),
        u1(s.u().last()),
        v0(s.v().first()),
        v1(s.v().last()),
        width_u(u1 - u0),
        width_v(v1 - v0) {}
  Domain(const CellPolynomials& s, Index a, Index b)
      : u0(s.u().low(a)),
        u1(s.u().high(a)),
        v0(s.v().low(b)),
        v1(s.v().high(b)),
        width_u(u1 - u0),
        width_v(v1 - v0) {}
};

struct Step {
  double u = 0, v = 0;
};

/// Along one coordinate alone.
Step along(bool u, double gradient, double curvature) {
  const double step = curvature > 0 ? -gradient / curvature : 0;
  return u ? Step{step, 0} : Step{0, step};
}

/// The Gauss-Newton step; zero where there is nowhere to go.
Step gauss_newton(const Domain& domain, const Jet& j, const Vec3& r, Slide slide, const double* p) {
  if (slide == Slide::fixed) return {};
  const double gu = dot(r, j.u), gv = dot(r, j.v), a = squared(j.u), c = squared(j.v);
  const bool low_u = p[0] <= domain.u0, high_u = p[0] >= domain.u1;
  const bool low_v = p[1] <= domain.v0, high_v = p[1] >= domain.v1;
  const bool out_u = (low_u && gu > 0) || (high_u && gu < 0), out_v = (low_v && gv > 0) || (high_v && gv < 0);
  if (slide == Slide::round) {  // at a corner: along the side that leads down, the steeper of two
    const bool side_u = low_v || high_v, side_v = low_u || high_u;
    const bool by_u = side_u && !out_u, by_v = side_v && !out_v;
    if (by_u && by_v)
      return along(gu * gu * c >= gv * gv * a, gu * gu * c >= gv * gv * a ? gu : gv,
                   gu * gu * c >= gv * gv * a ? a : c);
    return by_u ? along(true, gu, a) : by_v ? along(false, gv, c) : Step{};
  }
  const bool stay_u = slide == Slide::along_v || out_u, stay_v = slide == Slide::along_u || out_v;
  if (stay_u && stay_v) return {};
  if (stay_u) return along(false, gv, c);
  if (stay_v) return along(true, gu, a);
  // One of them hardly there: the other alone.
  const double along_u = a * domain.width_u * domain.width_u, along_v = c * domain.width_v * domain.width_v;
  if (std::min(along_u, along_v) <= 1e-20 * std::max(along_u, along_v))
    return along(along_u >= along_v, along_u >= along_v ? gu : gv, along_u >= along_v ? a : c);
  // The diagonal 1e-6 larger: S_u and S_v may be parallel.
  constexpr double more = 1 + 1e-6;
  const double b = dot(j.u, j.v), determinant = a * c * more * more - b * b;
  return {-(c * more * gu - b * gv) / determinant, -(a * more * gv - b * gu) / determinant};
}

constexpr Index kBatch = 1024;
constexpr int kHalvings = 6;

/// The points of one batch, in the order of their cells.
struct Batch {
  Index n = 0;
  std::array<double, 2 * kBatch> uv, trial;
  std::array<Jet, kBatch> jet, trial_jet;
  std::array<Vec3, kBatch> point;
  std::array<double, kBatch> distance;
  std::array<Slide, kBatch> slide;
  std::array<Step, kBatch> step;
  std::array<Index, kBatch> active, pending;

  void run(const CellPolynomials& surface, const FootPointOptions& options) {
    const Domain domain(surface);
    surface.jets({uv.data(), static_cast<std::size_t>(2 * n)}, jet.data());
    for (Index k = 0; k < n; ++k) distance[k] = squared(jet[k].s - point[k]);
    Index actives = n;
    for (Index k = 0; k < n; ++k) active[k] = k;
    for (int iteration = 0; iteration < options.iterations && actives > 0; ++iteration) {
      Index pendings = 0;
      for (Index i = 0; i < actives; ++i) {
        const Index k = active[i];
        Step s = gauss_newton(domain, jet[k], jet[k].s - point[k], slide[k], &uv[2 * k]);
        const double over = std::max(std::abs(s.u) / options.longest_u, std::abs(s.v) / options.longest_v);
        if (!(over > 0) || !std::isfinite(over)) continue;
        if (over > 1) s.u /= over, s.v /= over;
        step[k] = s;
        pending[pendings++] = k;
      }
      actives = 0;
      for (int halving = 0; halving < kHalvings && pendings > 0; ++halving) {
        for (Index i = 0; i < pendings; ++i) {
          const Index k = pending[i];
          trial[2 * i] = std::clamp(uv[2 * k] + step[k].u, domain.u0, domain.u1);
          trial[2 * i + 1] = std::clamp(uv[2 * k + 1] + step[k].v, domain.v0, domain.v1);
        }
        surface.jets({trial.data(), static_cast<std::size_t>(2 * pendings)}, trial_jet.data());
        Index left = 0;
        for (Index i = 0; i < pendings; ++i) {
          const Index k = pending[i];
          const double d = squared(trial_jet[i].s - point[k]);
          if (d < distance[k]) {
            if (distance[k] - d > 1e-10 * distance[k]) active[actives++] = k;
            distance[k] = d;
            jet[k] = trial_jet[i];
            uv[2 * k] = trial[2 * i];
            uv[2 * k + 1] = trial[2 * i + 1];
          } else {
            step[k].u /= 2, step[k].v /= 2;
            pending[left++] = k;
          }
        }
        pendings = left;
      }
      // Those that took a shorter step came later: back into cell order.
      std::sort(active.begin(), active.begin() + actives);
    }
  }
};

}  // namespace

std::vector<double> foot_points(const CellPolynomials& surface, std::span<const Vec3> points,
                                std::span<const Slide> slide, const FootPointOptions& options,
                                std::span<double> uv, std::span<Jet> jets) {
  const std::vector<std::int32_t> order = order_by_cell(surface, uv);
  std::vector<double> distances(points.size());
  parallel_chunks(
      static_cast<Index>(points.size()),
      [&](Index, Index begin, Index end) {
        const auto batch = std::make_unique<Batch>();
        batch->n = end - begin;
        for (Index i = 0; i < batch->n; ++i) {
          const std::int32_t k = order[begin + i];
          batch->point[i] = points[k];
          batch->slide[i] = slide.empty() ? Slide::free : slide[k];
          batch->uv[2 * i] = uv[2 * k];
          batch->uv[2 * i + 1] = uv[2 * k + 1];
        }
        batch->run(surface, options);
        for (Index i = 0; i < batch->n; ++i) {
          const std::int32_t k = order[begin + i];
          uv[2 * k] = batch->uv[2 * i];
          uv[2 * k + 1] = batch->uv[2 * i + 1];
          distances[k] = batch->distance[i];
          if (!jets.empty()) jets[k] = batch->jet[i];
        }
      },
      kBatch);
  return distances;
}

namespace {

/// \param jet_at  Jet(u, v, second)
template <class JetAt>
double newton(const Domain& domain, double longest_u, double longest_v, const JetAt& jet_at,
              const Vec3& point, double* uv) {
  constexpr int iterations = 40;
  SecondDerivatives second;
  Jet j = jet_at(uv[0], uv[1], second);
  double distance = squared(j.s - point);
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const Vec3 r = j.s - point;
    const double gu = dot(r, j.u), gv = dot(r, j.v);
    const bool out_u = (uv[0] <= domain.u0 && gu > 0) || (uv[0] >= domain.u1 && gu < 0);
    const bool out_v = (uv[1] <= domain.v0 && gv > 0) || (uv[1] >= domain.v1 && gv < 0);
    Step s;
    const double hu = squared(j.u) + dot(r, second.uu), hv = squared(j.v) + dot(r, second.vv);
    const double huv = dot(j.u, j.v) + dot(r, second.uv), determinant = hu * hv - huv * huv;
    if (out_u && out_v) break;
    if (out_u)
      s = along(false, gv, hv > 0 ? hv : squared(j.v));
    else if (out_v)
      s = along(true, gu, hu > 0 ? hu : squared(j.u));
    else if (hu > 0 && hv > 0 && determinant > 1e-12 * hu * hv)
      s = {-(hv * gu - huv * gv) / determinant, -(hu * gv - huv * gu) / determinant};
    else
      s = gauss_newton(domain, j, r, Slide::free, uv);
    const double over = std::max(std::abs(s.u) / longest_u, std::abs(s.v) / longest_v);
    if (!(over > 0) || !std::isfinite(over)) break;
    if (over > 1) s.u /= over, s.v /= over;
    bool moved = false;
    for (int halving = 0; halving < 12 && !moved; ++halving, s.u *= 0.4, s.v *= 0.4) {
      const double trial[2] = {std::clamp(uv[0] + s.u, domain.u0, domain.u1),
                               std::clamp(uv[1] + s.v, domain.v0, domain.v1)};
      SecondDerivatives trial_second;
      const Jet at = jet_at(trial[0], trial[1], trial_second);
      const double d = squared(at.s - point);
      if (!(d < distance)) continue;
      moved = distance - d > 1e-15 * distance;
      distance = d;
      uv[0] = trial[0], uv[1] = trial[1];
      j = at;
      second = trial_second;
      break;
    }
    if (!moved) break;
  }
  return distance;
}

}  // namespace

double polish(const CellPolynomials& surface, const Vec3& point, double* uv) {
  const auto jet_at = [&](double u, double v, SecondDerivatives& d) { return surface.jet(u, v, d); };
  return newton(Domain(surface), surface.u().mean_length(), surface.v().mean_length(), jet_at, point, uv);
}

double polish_in_cell(const CellPolynomials& surface, Index a, Index b, const Vec3& point, double* uv) {
  const Domain domain(surface, a, b);
  const auto jet_at = [&](double u, double v, SecondDerivatives& d) { return surface.jet(a, b, u, v, d); };
  return newton(domain, domain.width_u, domain.width_v, jet_at, point, uv);
}

}  // namespace knotfit
