#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double norm(const Vector& a) {
  return std::hypot(a[0], a[1], a[2]);
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector scaled(const Vector& a, double factor) {
  return {a[0] * factor, a[1] * factor, a[2] * factor};
}

}  // namespace

LocalGeometry local_geometry(const Surface& s, double u, double v) {
  if (s.empty()) throw InvalidInput("the surface to evaluate is empty");
  if (s.dimension() != 3)
    throw InvalidInput(
        fmt::format("normals and curvatures need a surface in R^3, not R^{}; a height field becomes "
                    "one by height_field_in_space",
                    s.dimension()));
  const std::vector<double> all = evaluate_derivatives(s, u, v, 2);
  const auto derivative = [&](int a, int b) {
    const double* at = all.data() + (a * 3 + b) * 3;
    return Vector{at[0], at[1], at[2]};
  };
  LocalGeometry g;
  g.point = derivative(0, 0);
  if (std::isnan(g.point[0])) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    g.normal = {nan, nan, nan};
    g.mean_curvature = g.gaussian_curvature = g.k1 = g.k2 = g.area_element = nan;
    g.degenerate = true;
    return g;
  }
  const Vector su = derivative(1, 0), sv = derivative(0, 1);
  const double length_u = norm(su), length_v = norm(sv);
  if (length_u == 0 || length_v == 0) {
    g.degenerate = true;
    return g;
  }
  // In the orthonormal frame e1 = S_u / |S_u|, e2 of the tangent plane, with S_u = |S_u| e1 and
  // S_v = |S_v| (c e1 + n e2): no difference of large products, as EG - F^2 would be.
  const Vector e1 = scaled(su, 1 / length_u), direction_v = scaled(sv, 1 / length_v);
  const Vector product = cross(e1, direction_v);
  const double sine = norm(product), cosine = dot(e1, direction_v);
  g.area_element = length_u * length_v * sine;
  if (sine < 1e-12) {
    g.degenerate = true;
    return g;
  }
  g.normal = scaled(product, 1 / sine);
  const double l = dot(derivative(2, 0), g.normal) / length_u / length_u;
  const double m = dot(derivative(1, 1), g.normal) / length_u / length_v;
  const double n = dot(derivative(0, 2), g.normal) / length_v / length_v;
  // Second fundamental form in that frame: e2 = (S_v / |S_v| - c e1) / sine [doCarmo76 3.3].
  const double b11 = l, b12 = (m - cosine * l) / sine;
  const double b22 = (n - 2 * cosine * m + cosine * cosine * l) / sine / sine;
  g.mean_curvature = (b11 + b22) / 2;
  g.gaussian_curvature = b11 * b22 - b12 * b12;
  const double radius = std::hypot((b11 - b22) / 2, b12);
  g.k1 = g.mean_curvature + radius;
  g.k2 = g.mean_curvature - radius;
  return g;
}

}  // namespace knotfit
