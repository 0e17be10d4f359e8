#include "knotfit/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

std::string place(const ParameterizedPoints& points, Index k) {
  return points.source.empty() ? fmt::format("point {}", k)
                               : fmt::format("point {} (line {})", k, points.source[k]);
}

}  // namespace

std::array<double, 2> ParameterMap::shear(double s, double t) const {
  return {(s + shear_u * t - std::min(shear_u, 0.0)) / (1 + std::abs(shear_u)),
          (t + shear_v * s - std::min(shear_v, 0.0)) / (1 + std::abs(shear_v))};
}

std::array<double, 2> ParameterMap::unshear(double u, double v) const {
  // One shear is 0: its coordinate is known first.
  const double s = u * (1 + std::abs(shear_u)) + std::min(shear_u, 0.0);
  const double t = v * (1 + std::abs(shear_v)) + std::min(shear_v, 0.0);
  return {s - shear_u * t, t - shear_v * s};
}

bool ParameterMap::covers(double u, double v) const {
  constexpr double kRounding = 1e-12;
  const auto [s, t] = unshear(u, v);
  return std::min(s, t) >= -kRounding && std::max(s, t) <= 1 + kRounding;
}

ParameterizedPoints sheared(const ParameterizedPoints& points, double shear_u, double shear_v) {
  if (!(std::abs(shear_u) <= 1) || !(std::abs(shear_v) <= 1) || (shear_u != 0 && shear_v != 0))
    throw InvalidInput(
        fmt::format("a shear of {} in u and {} in v: one must be 0, the other in [-1,1]", shear_u, shear_v));
  ParameterizedPoints result = points;
  result.map.shear_u = shear_u;
  result.map.shear_v = shear_v;
  for (Index k = 0; k < points.size(); ++k) {
    const auto [s, t] = points.map.unshear(points.u(k), points.v(k));
    const auto [u, v] = result.map.shear(s, t);
    result.uv[2 * k] = std::clamp(u, 0.0, 1.0);
    result.uv[2 * k + 1] = std::clamp(v, 0.0, 1.0);
  }
  return result;
}

void validate(const ParameterizedPoints& points) {
  const Index n = points.size();
  if (points.dimension < 1)
    throw InvalidInput(fmt::format("points of dimension {}: it must be at least 1", points.dimension));
  if (n == 0) throw InvalidInput("no points to fit");
  if (points.uv.size() % 2 != 0 || points.values.size() != static_cast<std::size_t>(n * points.dimension))
    throw InvalidInput(
        fmt::format("{} parameters for {} values of dimension {}: one (u, v) a point is needed",
                    points.uv.size(), points.values.size(), points.dimension));
  if (!points.weights.empty() && points.weights.size() != static_cast<std::size_t>(n))
    throw InvalidInput(fmt::format("{} weights for {} points", points.weights.size(), n));
  if (!points.source.empty() && points.source.size() != static_cast<std::size_t>(n))
    throw InvalidInput(fmt::format("{} source lines for {} points", points.source.size(), n));
  for (Index k = 0; k < n; ++k) {
    const double u = points.u(k), v = points.v(k);
    if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1))
      throw InvalidInput(fmt::format("{} has parameters ({}, {}), outside [0,1]; rescale the parameters",
                                     place(points, k), u, v));
    for (int d = 0; d < points.dimension; ++d)
      if (!std::isfinite(points.value(k)[d]))
        throw InvalidInput(fmt::format("{} has a value that is not finite", place(points, k)));
    if (!points.weights.empty() && !(points.weights[k] > 0 && std::isfinite(points.weights[k])))
      throw InvalidInput(fmt::format("{} has weight {}: weights must be positive and finite",
                                     place(points, k), points.weights[k]));
  }
}

double bounding_diagonal(const ParameterizedPoints& points) {
  double diagonal = 0;
  for (int d = 0; d < points.dimension; ++d) {
    double low = INFINITY, high = -INFINITY;
    for (Index k = 0; k < points.size(); ++k) {
      low = std::min(low, points.value(k)[d]);
      high = std::max(high, points.value(k)[d]);
    }
    diagonal = std::hypot(diagonal, high - low);  // no square of a huge or tiny range
  }
  return points.size() > 0 ? diagonal : 0;
}

namespace {

/// Whether the first points alone show that no grid holds them all: one direction of a grid of n points has at most sqrt(n)
/// lines.
bool surely_no_grid(const ParameterizedPoints& points) {
  const Index most = static_cast<Index>(std::sqrt(static_cast<double>(points.size()))) + 1;
  const Index looked = std::min(points.size(), 4 * most);
  const auto lines = [&](int axis) {
    std::vector<double> t(static_cast<std::size_t>(looked));
    for (Index k = 0; k < looked; ++k) t[k] = points.uv[2 * k + axis];
    std::sort(t.begin(), t.end());
    return std::unique(t.begin(), t.end()) - t.begin();
  };
  return lines(0) > most && lines(1) > most;
}

}  // namespace

GridLayout find_grid(const ParameterizedPoints& points) {
  const Index n = points.size();
  if (surely_no_grid(points)) return {};
  GridLayout grid;
  auto lines = [&](int axis) {
    std::vector<double> t(static_cast<std::size_t>(n));
    for (Index k = 0; k < n; ++k) t[k] = points.uv[2 * k + axis];
    std::sort(t.begin(), t.end());
    t.erase(std::unique(t.begin(), t.end()), t.end());
    return t;
  };
  if (n == 0) return {};
  grid.u = lines(0);
  if (n % static_cast<Index>(grid.u.size()) != 0 || grid.u.size() < 2) return {};
  grid.v = lines(1);
  const Index size_v = static_cast<Index>(grid.v.size());
  if (static_cast<Index>(grid.u.size()) * size_v != n || size_v < 2) return {};
  grid.point.assign(static_cast<std::size_t>(n), -1);
  for (Index k = 0; k < n; ++k) {
    const Index i = std::lower_bound(grid.u.begin(), grid.u.end(), points.u(k)) - grid.u.begin();
    const Index j = std::lower_bound(grid.v.begin(), grid.v.end(), points.v(k)) - grid.v.begin();
    Index& slot = grid.point[i * size_v + j];
    if (slot >= 0) return {};
    slot = k;
  }
  return grid;
}

}  // namespace knotfit
