#include "knotfit/features.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "base/parallel.h"
#include "base/uniform_cell.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

std::vector<double> cell_centres(Index size) {
  std::vector<double> t(size);
  for (Index i = 0; i < size; ++i) t[i] = (static_cast<double>(i) + 0.5) / static_cast<double>(size);
  return t;
}

/// The derivatives of a surface at the centres of size x size cells, each size x size x dimension.
struct SampledDerivatives {
  Index size;
  int dimension;
  std::vector<double> u, v, uu, uv, vv;
  SampledDerivatives(const Surface& s, Index n) : size(n), dimension(s.dimension()) {
    if (n < 1) throw InvalidInput("a feature map needs at least one cell a direction");
    const std::vector<double> t = cell_centres(n);
    u = evaluate_grid(s, t, t, 1, 0);
    v = evaluate_grid(s, t, t, 0, 1);
    uu = evaluate_grid(s, t, t, 2, 0);
    uv = evaluate_grid(s, t, t, 1, 1);
    vv = evaluate_grid(s, t, t, 0, 2);
  }
};

/// Average of the values of each cell's points; cells without points take the nearest cell's value
/// (breadth first, so ties go to the smaller index).
FeatureMap averaged(const ParameterizedPoints& points, const std::vector<double>& values, Index size) {
  validate(points);
  if (size < 1) throw InvalidInput("a feature map needs at least one cell a direction");
  if (static_cast<Index>(values.size()) != points.size())
    throw InvalidInput(fmt::format("{} feature values for {} points", values.size(), points.size()));
  FeatureMap map{size, size, std::vector<double>(size * size, 0.0)};
  std::vector<Index> count(size * size, 0);
  for (Index k = 0; k < points.size(); ++k) {
    if (!(values[k] >= 0) || !std::isfinite(values[k]))
      throw InvalidInput(
          fmt::format("the feature value of point {} is {}: it must be finite and at least 0", k, values[k]));
    const Index c = uniform_cell(points.u(k), size) * size + uniform_cell(points.v(k), size);
    map.f[c] += values[k];
    ++count[c];
  }
  std::queue<Index> front;
  for (Index c = 0; c < size * size; ++c)
    if (count[c] > 0) {
      map.f[c] /= static_cast<double>(count[c]);
      front.push(c);
    }
  while (!front.empty()) {
    const Index c = front.front(), i = c / size, j = c % size;
    front.pop();
    for (auto [di, dj] : {std::pair{-1, 0}, {0, -1}, {0, 1}, {1, 0}}) {
      if (i + di < 0 || i + di >= size || j + dj < 0 || j + dj >= size) continue;
      const Index next = (i + di) * size + j + dj;
      if (count[next] > 0) continue;
      count[next] = 1;
      map.f[next] = map.f[c];
      front.push(next);
    }
  }
  return map;
}

}  // namespace

void validate(const FeatureMap& map) {
  if (map.size_u < 1 || map.size_v < 1 || static_cast<Index>(map.f.size()) != map.size_u * map.size_v)
    throw InvalidInput(
        fmt::format("a feature map of {} x {} cells with {} values", map.size_u, map.size_v, map.f.size()));
  for (Index c = 0; c < static_cast<Index>(map.f.size()); ++c)
    if (!(map.f[c] >= 0) || !std::isfinite(map.f[c]))
      throw InvalidInput(
          fmt::format("the feature measure of cell ({}, {}) is {}: it must be finite and at least 0",
                      c / map.size_v, c % map.size_v, map.f[c]));
}

FeatureMap hessian_features(const Surface& s, Index size) {
  const SampledDerivatives d(s, size);
  FeatureMap map{size, size, std::vector<double>(size * size)};
  for (Index c = 0; c < size * size; ++c) {
    double sum = 0;
    for (int e = 0; e < d.dimension; ++e) {
      const Index k = c * d.dimension + e;
      sum += d.uu[k] * d.uu[k] + 2 * d.uv[k] * d.uv[k] + d.vv[k] * d.vv[k];
    }
    map.f[c] = std::sqrt(std::sqrt(sum));
  }
  return map;
}

FeatureMap curvature_features(const Surface& s, Index size) {
  if (s.dimension() != 1 && s.dimension() != 3)
    throw InvalidInput(
        fmt::format("curvature needs a height field or a surface in R^3, not dimension {}", s.dimension()));
  const SampledDerivatives d(s, size);
  using Vector = std::array<double, 3>;
  auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  FeatureMap map{size, size, std::vector<double>(size * size)};
  for (Index c = 0; c < size * size; ++c) {
    // Height fields are surfaces (u, v, z).
    auto at = [&](const std::vector<double>& x, double du, double dv) {
      return d.dimension == 1 ? Vector{du, dv, x[c]} : Vector{x[3 * c], x[3 * c + 1], x[3 * c + 2]};
    };
    const Vector u = at(d.u, 1, 0), v = at(d.v, 0, 1), uu = at(d.uu, 0, 0), uv = at(d.uv, 0, 0),
                 vv = at(d.vv, 0, 0);
    const double e = dot(u, u), f = dot(u, v), g = dot(v, v), area2 = e * g - f * f;
    if (!(area2 > 1e-24 * e * g)) continue;  // degenerate: no curvature to speak of
    const Vector n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double area = std::sqrt(area2);
    const double l = dot(uu, n) / area, m = dot(uv, n) / area, k = dot(vv, n) / area;
    const double mean = (e * k - 2 * f * m + g * l) / (2 * area2), gauss = (l * k - m * m) / area2;
    map.f[c] = std::sqrt(std::sqrt(std::max(0.0, 4 * mean * mean - 2 * gauss))) * area;
  }
  return map;
}

FeatureMap derivative_features(const Surface& s, Index size) {
  const std::vector<double> t = cell_centres(size);
  const std::vector<double> u = evaluate_grid(s, t, t, s.degree_u(), 0),
                            v = evaluate_grid(s, t, t, 0, s.degree_v());
  FeatureMap map{size, size, std::vector<double>(size * size)};
  for (Index c = 0; c < size * size; ++c) {
    double sum = 0;
    for (int e = 0; e < s.dimension(); ++e) {
      const Index k = c * s.dimension() + e;
      sum += u[k] * u[k] + v[k] * v[k];
    }
    map.f[c] = std::pow(sum, 1.0 / (s.degree_u() + s.degree_v()));
  }
  return map;
}

FeatureMap residual_features(const ParameterizedPoints& points, const std::vector<double>& errors,
                             Index size) {
  std::vector<double> squares(errors.size());
  for (std::size_t k = 0; k < errors.size(); ++k) squares[k] = errors[k] * errors[k];
  return averaged(points, squares, size);
}

FeatureMap point_features(const ParameterizedPoints& points, const std::vector<double>& f, Index size) {
  return averaged(points, f, size);
}

}  // namespace knotfit
