#include "place/free_net.h"

#include <array>

#include "base/parallel.h"
#include "fit/knot_basis.h"
#include "fit/knot_jacobian.h"
#include "place/knot_spacings.h"
namespace knotfit {
namespace {

constexpr int kWidth = kMaxDegree + 1;

void add(std::vector<double>& a, const std::vector<double>& b) {
  if (a.empty()) a.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += b[i];
}

}  // namespace

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

FreeNet& FreeNet::operator+=(const FreeNet& o) {
  phi += o.phi;
  add(by_net, o.by_net);
  add(by_knots, o.by_knots);
  return *this;
}

FreeNet free_net(const ParameterizedPoints& points, const Axis& u, const Axis& v,
                 const std::vector<double>& net, bool with_knots) {
  const int d = points.dimension, wu = u.width(), wv = v.width();
  const Index nv = v.functions(), knots_u = u.spans() - 1, knots_v = v.spans() - 1;
  const std::vector<double> du = with_knots ? knot_derivatives(u) : std::vector<double>{};
  const std::vector<double> dv = with_knots ? knot_derivatives(v) : std::vector<double>{};
  return parallel_sum<FreeNet>(points.size(), [&](Index begin, Index end) {
    FreeNet part;
    part.by_net.assign(net.size(), 0.0);
    if (with_knots) part.by_knots.assign(knots_u + knots_v, 0.0);
    KnotBasis a, b;
    std::vector<double> residual(d);
    std::array<double, kWidth> along_u{}, along_v{};  // r . (row of the net times the other basis)
    for (Index k = begin; k < end; ++k) {
      a.set(u, du, points.u(k));
      b.set(v, dv, points.v(k));
      const double* block = net.data() + (a.span * nv + b.span) * d;
      for (int e = 0; e < d; ++e) residual[e] = -points.value(k)[e];
      for (int i = 0; i < wu; ++i)
        for (int j = 0; j < wv; ++j)
          for (int e = 0; e < d; ++e) residual[e] += a.value[i] * b.value[j] * block[(i * nv + j) * d + e];
      const double w = points.weight(k);
      for (int e = 0; e < d; ++e) part.phi += w * residual[e] * residual[e];
      double* out = part.by_net.data() + (a.span * nv + b.span) * d;
      for (int i = 0; i < wu; ++i)
        for (int j = 0; j < wv; ++j)
          for (int e = 0; e < d; ++e)
            out[(i * nv + j) * d + e] += 2 * w * a.value[i] * b.value[j] * residual[e];
      if (!with_knots) continue;
      along_u.fill(0);
      along_v.fill(0);
      for (int i = 0; i < wu; ++i)
        for (int j = 0; j < wv; ++j) {
          double dot = 0;
          for (int e = 0; e < d; ++e) dot += residual[e] * block[(i * nv + j) * d + e];
          along_u[i] += b.value[j] * dot;
          along_v[j] += a.value[i] * dot;
        }
      const auto gather = [&](const KnotBasis& at, const std::array<double, kWidth>& along, int width,
                              Index count, double* by) {
        const int m = width - 1;
        for (int e = 0; e < 2 * m; ++e) {
          const Index l = at.span - m + e;
          if (l < 0 || l >= count) continue;
          double sum = 0;
          for (int i = 0; i < width; ++i) sum += at.by_knot[e][i] * along[i];
          by[l] += 2 * w * sum;
        }
      };
      gather(a, along_u, wu, knots_u, part.by_knots.data());
      gather(b, along_v, wv, knots_v, part.by_knots.data() + knots_u);
    }
    return part;
  });
}

std::vector<double> net_row_sums(const ParameterizedPoints& points, const Axis& u, const Axis& v) {
  // The functions sum to 1, so the row sums of A^T W A are A^T w: the net's gradient for residuals of 1.
  ParameterizedPoints ones = points;
  ones.dimension = 1;
  ones.values.assign(points.size(), -1.0);
  FreeNet sums = free_net(ones, u, v, std::vector<double>(u.functions() * v.functions(), 0.0), false);
  for (double& x : sums.by_net) x /= 2;
  return sums.by_net;
}

std::vector<double> by_log_spacings(const InteriorKnots& knots, const std::vector<double>& by_knots) {
  std::vector<double> gradient;
  std::size_t row = 0;
  for (const auto* line : {&knots.u, &knots.v}) {
    const KnotSpacings spacings(*line);
    const std::size_t count = spacings.knot_count(), unknowns = spacings.length.size();
    std::vector<double> chain(count * unknowns, 0.0);
    if (count > 0) spacings.chain(chain, 0, 0, unknowns);
    for (std::size_t i = 0; i < unknowns; ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < count; ++k) sum += chain[k * unknowns + i] * by_knots[row + k];
      gradient.push_back(sum);
    }
    row += count;
  }
  return gradient;
}

}  // namespace knotfit
