// A surface as a grid of points.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/mesh_io.h"
namespace knotfit {
namespace {

constexpr double kMostPoints = 1e8;

std::vector<double> lines_of(const KnotVector& knots, int samples) {
  std::vector<double> breaks{knots.first()};
  for (const double k : knots.interior())
    if (k > breaks.back()) breaks.push_back(k);
  breaks.push_back(knots.last());
  std::vector<double> lines;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    for (int k = 0; k < samples; ++k) {
      const double at = breaks[i] + (breaks[i + 1] - breaks[i]) * k / samples;
      if (lines.empty() || at > lines.back()) lines.push_back(at);
    }
  lines.push_back(knots.last());
  return lines;
}

Index nearest(const std::vector<double>& lines, double at) {
  const Index k = std::lower_bound(lines.begin(), lines.end(), at) - lines.begin();
  if (k == 0) return 0;
  if (k == static_cast<Index>(lines.size())) return k - 1;
  return at - lines[k - 1] <= lines[k] - at ? k - 1 : k;
}

}  // namespace

Tessellation tessellate(const Surface& surface, int samples_per_span) {
  if (surface.dimension() != 3)
    throw InvalidInput(
        fmt::format("a surface of dimension {} has no mesh; dimension 3 has", surface.dimension()));
  if (samples_per_span < 1)
    throw InvalidInput(fmt::format("{} samples a span; there must be one or more", samples_per_span));
  Tessellation t;
  const auto spans = [](const KnotVector& k) { return static_cast<double>(k.interior().size()) + 1; };
  const double most =
      (spans(surface.knots_u()) * samples_per_span + 1) * (spans(surface.knots_v()) * samples_per_span + 1);
  if (most > kMostPoints)
    throw InvalidInput(
        fmt::format("{} samples a span make up to {:.3g} points; take fewer", samples_per_span, most));
  t.u = lines_of(surface.knots_u(), samples_per_span);
  t.v = lines_of(surface.knots_v(), samples_per_span);
  const std::size_t n = t.u.size() * t.v.size();
  t.points = evaluate_grid(surface, t.u, t.v);
  t.normals.resize(3 * n);
  t.mean_curvature.resize(n);
  t.gaussian_curvature.resize(n);
  parallel_for(static_cast<Index>(t.u.size()), [&](Index i) {
    for (std::size_t j = 0; j < t.v.size(); ++j) {
      const LocalGeometry g = local_geometry(surface, t.u[i], t.v[j]);
      const std::size_t k = static_cast<std::size_t>(i) * t.v.size() + j;
      std::copy(g.normal.begin(), g.normal.end(), t.normals.begin() + static_cast<Index>(3 * k));
      t.mean_curvature[k] = g.mean_curvature;
      t.gaussian_curvature[k] = g.gaussian_curvature;
    }
  });
  return t;
}

void add_errors(Tessellation& t, const ParameterizedPoints& points, std::span<const double> errors) {
  if (static_cast<Index>(errors.size()) != points.size())
    throw InvalidInput(fmt::format("{} errors for {} points", errors.size(), points.size()));
  t.error.assign(t.u.size() * t.v.size(), std::numeric_limits<double>::quiet_NaN());
  for (Index k = 0; k < points.size(); ++k) {
    double& at = t.error[static_cast<std::size_t>(nearest(t.u, points.u(k))) * t.v.size() +
                         static_cast<std::size_t>(nearest(t.v, points.v(k)))];
    if (!(at >= errors[k])) at = errors[k];
  }
}

}  // namespace knotfit
