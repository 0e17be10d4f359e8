#include "nearest/foot_points.h"

#include <array>
#include <cmath>
#include <memory>

#include "base/parallel.h"
namespace knotfit {
namespace {

struct Step {
  double u = 0, v = 0;
};

/// The rectangle that the parameters stay in.
struct Domain {
  double u0, u1, v0, v1;
  explicit Domain(const CellPolynomials& s)
      : Domain(s.u().first(), s.u().last(), s.v().first(), s.v().last()) {}
  Domain(const CellPolynomials& s, Index a, Index b)
      : Domain(s.u().low(a), s.u().high(a), s.v().low(b), s.v().high(b)) {}
  double width_u() const { return u1 - u0; }
  double width_v() const { return v1 - v0; }
  void go(const double* from, const Step& step, double* to) const {
    to[0] = std::clamp(from[0] + step.u, u0, u1);
    to[1] = std::clamp(from[1] + step.v, v0, v1);
  }

 private:
  Domain(double low_u, double high_u, double low_v, double high_v)
      : u0(low_u), u1(high_u), v0(low_v), v1(high_v) {}
};

/// Along one coordinate alone.
Step along(bool u, double gradient, double curvature) {
  const double step = curvature > 0 ? -gradient / curvature : 0;
  return u ? Step{step, 0} : Step{0, step};
}

/// Newton's step where the second derivatives are given and the Hessian is positive definite, else the Gauss-Newton
/// step; zero where there is nowhere to go. \param r  S - P
Step step_of(const Domain& domain, const Jet& j, const Vec3& r, Slide slide, const double* p,
             const SecondDerivatives* second = nullptr) {
  if (slide == Slide::fixed) return {};
  const double gu = dot(r, j.u), gv = dot(r, j.v), a = squared(j.u), c = squared(j.v);
  const bool low_u = p[0] <= domain.u0, high_u = p[0] >= domain.u1;
  const bool low_v = p[1] <= domain.v0, high_v = p[1] >= domain.v1;
  const bool out_u = (low_u && gu > 0) || (high_u && gu < 0), out_v = (low_v && gv > 0) || (high_v && gv < 0);
  const auto along_one = [&](bool u) { return u ? along(true, gu, a) : along(false, gv, c); };
  if (slide == Slide::round) {  // at a corner: the side that leads down, the steeper of two
    const bool side_u = low_v || high_v, side_v = low_u || high_u;
    const bool by_u = side_u && !out_u, by_v = side_v && !out_v;
    if (!by_u && !by_v) return {};
    return along_one(by_u && by_v ? gu * gu * c >= gv * gv * a : by_u);
  }
  const bool stay_u = slide == Slide::along_v || out_u, stay_v = slide == Slide::along_u || out_v;
  const double hu = second ? a + dot(r, second->uu) : a, hv = second ? c + dot(r, second->vv) : c;
  if (stay_u && stay_v) return {};
  if (stay_u) return along(false, gv, hv > 0 ? hv : c);
  if (stay_v) return along(true, gu, hu > 0 ? hu : a);
  const double b = dot(j.u, j.v);
  if (second) {
    constexpr double least = 1e-12;  // of hu hv: a smaller determinant is taken for that of a saddle
    const double huv = b + dot(r, second->uv), determinant = hu * hv - huv * huv;
    if (hu > 0 && hv > 0 && determinant > least * hu * hv)
      return {-(hv * gu - huv * gv) / determinant, -(hu * gv - huv * gu) / determinant};
  }
  // One derivative nearly vanishes: the step goes along the other alone.
  const double along_u = a * domain.width_u() * domain.width_u(),
               along_v = c * domain.width_v() * domain.width_v();
  if (std::min(along_u, along_v) <= 1e-20 * std::max(along_u, along_v)) return along_one(along_u >= along_v);
  // S_u and S_v may be parallel: a diagonal 1e-6 larger keeps the matrix regular.
  constexpr double more = 1 + 1e-6;
  const double determinant = a * c * more * more - b * b;
  return {-(c * more * gu - b * gv) / determinant, -(a * more * gv - b * gu) / determinant};
}

/// Shortens a step to the longest allowed. \return false where it leads nowhere
bool limit(Step& step, double longest_u, double longest_v) {
  const double over = std::max(std::abs(step.u) / longest_u, std::abs(step.v) / longest_v);
  if (!(over > 0) || !std::isfinite(over)) return false;
  if (over > 1) step.u /= over, step.v /= over;
  return true;
}

constexpr Index kBlock = 1024;
constexpr int kHalvings = 6;

/// Points taken side by side, in the order of their cells.
struct PointBlock {
  Index n = 0;
  std::array<double, 2 * kBlock> uv, trial;
  std::array<Jet, kBlock> jet, trial_jet;
  std::array<Vec3, kBlock> point;
  std::array<double, kBlock> distance;
  std::array<Slide, kBlock> slide;
  std::array<Step, kBlock> step;
  std::array<Index, kBlock> active, pending;

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
        step[k] = step_of(domain, jet[k], jet[k].s - point[k], slide[k], &uv[2 * k]);
        if (limit(step[k], options.longest_u, options.longest_v)) pending[pendings++] = k;
      }
      actives = 0;
      for (int halving = 0; halving < kHalvings && pendings > 0; ++halving) {
        for (Index i = 0; i < pendings; ++i) domain.go(&uv[2 * pending[i]], step[pending[i]], &trial[2 * i]);
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
      // Points that took a shorter step were added later.
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
        const auto block = std::make_unique<PointBlock>();
        block->n = end - begin;
        for (Index i = 0; i < block->n; ++i) {
          const std::int32_t k = order[begin + i];
          block->point[i] = points[k];
          block->slide[i] = slide.empty() ? Slide::free : slide[k];
          block->uv[2 * i] = uv[2 * k];
          block->uv[2 * i + 1] = uv[2 * k + 1];
        }
        block->run(surface, options);
        for (Index i = 0; i < block->n; ++i) {
          const std::int32_t k = order[begin + i];
          uv[2 * k] = block->uv[2 * i];
          uv[2 * k + 1] = block->uv[2 * i + 1];
          distances[k] = block->distance[i];
          if (!jets.empty()) jets[k] = block->jet[i];
        }
      },
      kBlock);
  return distances;
}

namespace {

/// \param jet_at  Jet(u, v, second)
template <class JetAt>
double newton(const Domain& domain, double longest_u, double longest_v, const JetAt& jet_at,
              const Vec3& point, double* uv) {
  constexpr int iterations = 40, most_trials = 12;
  SecondDerivatives second;
  Jet j = jet_at(uv[0], uv[1], second);
  double distance = squared(j.s - point);
  bool moved = true;
  for (int iteration = 0; iteration < iterations && moved; ++iteration) {
    Step step = step_of(domain, j, j.s - point, Slide::free, uv, &second);
    if (!limit(step, longest_u, longest_v)) break;
    moved = false;
    for (int trials = 0; trials < most_trials; ++trials, step.u *= 0.4, step.v *= 0.4) {
      double trial[2];
      domain.go(uv, step, trial);
      SecondDerivatives trial_second;
      const Jet trial_jet = jet_at(trial[0], trial[1], trial_second);
      const double d = squared(trial_jet.s - point);
      if (!(d < distance)) continue;
      moved = distance - d > 1e-15 * distance;
      distance = d;
      uv[0] = trial[0], uv[1] = trial[1];
      j = trial_jet;
      second = trial_second;
      break;
    }
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
  return newton(domain, domain.width_u(), domain.width_v(), jet_at, point, uv);
}

}  // namespace knotfit
