#include "pipeline/request.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "data/strays.h"
#include "fit/error_measure.h"
#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
namespace knotfit {
namespace {

/// No surface runs through points that are all equal or lie on one straight line in R^d, d >= 2.
/// Rank by the two largest spreads: the far point from the first, then the far point from that line.
void check_extent(const ParameterizedPoints& points) {
  const int d = points.dimension;
  if (d == 1) return;
  // In the frame's unit, where no square overflows or vanishes.
  const Frame frame(points);
  const double unit = frame.scale(), rounding = frame.rounding() / unit;
  auto farthest = [&](auto&& distance) {
    double most = 0;
    Index at = 0;
    for (Index k = 0; k < points.size(); ++k)
      if (const double x = distance(points.value(k)); x > most) {
        most = x;
        at = k;
      }
    return std::pair{most, at};
  };
  const double* origin = points.value(0);
  const auto [length, far] = farthest([&](const double* p) {
    double sum = 0;
    for (int e = 0; e < d; ++e) sum += (p[e] - origin[e]) / unit * ((p[e] - origin[e]) / unit);
    return std::sqrt(sum);
  });
  if (!(length > 4 * rounding)) throw InvalidInput("all points are equal: there is no surface to fit");
  std::vector<double> direction(d);
  for (int e = 0; e < d; ++e) direction[e] = (points.value(far)[e] - origin[e]) / unit / length;
  const double off = farthest([&](const double* p) {
                       double along = 0, sum = 0;
                       for (int e = 0; e < d; ++e) along += (p[e] - origin[e]) / unit * direction[e];
                       for (int e = 0; e < d; ++e) {
                         const double x = (p[e] - origin[e]) / unit - along * direction[e];
                         sum += x * x;
                       }
                       return std::sqrt(sum);
                     }).first;
  if (!(off > std::max(8 * rounding, 1e-14 * length))) {
    if (const std::vector<Index> strays = far_strays(points.values, d); !strays.empty())
      throw InvalidInput(fmt::format(
          "{} stands so far from the others that these look like one place from there: a stray; leave it out",
          points.source.empty() ? fmt::format("point {} (from 1)", strays.front() + 1)
                                : fmt::format("line {}", points.source[strays.front()])));
    throw InvalidInput("all points lie on one straight line: there is no surface to fit");
  }
}

/// Parameters must spread over both directions, or a whole family of surfaces fits alike.
void check_parameters(const ParameterizedPoints& points) {
  double low[2] = {1, 1}, high[2] = {0, 0};
  Index first = 0, last = 0;  // ends along u
  for (Index k = 0; k < points.size(); ++k) {
    if (points.u(k) < points.u(first)) first = k;
    if (points.u(k) > points.u(last)) last = k;
    for (int axis : {0, 1}) {
      low[axis] = std::min(low[axis], points.uv[2 * k + axis]);
      high[axis] = std::max(high[axis], points.uv[2 * k + axis]);
    }
  }
  for (int axis : {0, 1})
    if (!(high[axis] > low[axis]))
      throw InvalidInput(fmt::format("all points have the same parameter {} = {}: there is no surface to fit",
                                     axis == 0 ? "u" : "v", low[axis]));
  const double du = points.u(last) - points.u(first), dv = points.v(last) - points.v(first);
  for (Index k = 0; k < points.size(); ++k)
    if (std::abs((points.u(k) - points.u(first)) * dv - (points.v(k) - points.v(first)) * du) >
        1e-14 * std::hypot(du, dv))
      return;
  throw InvalidInput(
      "the parameters (u, v) of all points lie on one straight line: there is no surface to fit");
}

void check_size(const ParameterizedPoints& points, const FitOptions& o) {
  const Index n = points.size(), patch = Index{o.degree_u + 1} * (o.degree_v + 1);
  if (n < patch)
    throw InvalidInput(
        fmt::format("{} points are fewer than the {} control points of one patch of degree {}x{}; "
                    "give more points or a lower {}",
                    n, patch, o.degree_u, o.degree_v, remedy_text(Remedy::degree)));
  Index size_u = o.control_points_u, size_v = o.control_points_v;
  if (o.knots) {
    size_u = static_cast<Index>(o.knots->u.size()) + o.degree_u + 1;
    size_v = static_cast<Index>(o.knots->v.size()) + o.degree_v + 1;
  } else if (size_u == 0 && size_v == 0) {
    return;
  }
  check_least_size(size_u, size_v, o.degree_u, o.degree_v);
  if (n < size_u * size_v)
    throw InvalidInput(
        fmt::format("{} points are fewer than {} x {} = {} control points; ask for fewer control points "
                    "or a lower {}",
                    n, size_u, size_v, size_u * size_v, remedy_text(Remedy::degree)));
}

}  // namespace

void check_least_size(Index size_u, Index size_v, int degree_u, int degree_v) {
  if (size_u < degree_u + 1 || size_v < degree_v + 1)
    throw InvalidInput(fmt::format("{} x {} control points: degree {}x{} needs at least {} x {}", size_u,
                                   size_v, degree_u, degree_v, degree_u + 1, degree_v + 1));
}

void check_requirements(const ParameterizedPoints& points, const FitOptions& options) {
  validate(points);
  if (options.degree_auto && options.knots)
    throw InvalidInput("degrees cannot be tried on given knots: give a degree, or leave the knots out");
  for (int degree : {options.degree_u, options.degree_v})
    if (degree < 1 || degree > kMaxDegree)
      throw InvalidInput(fmt::format("degree {}: it must be 1 to {}", degree, kMaxDegree));
  check_size(points, options);
  check_extent(points);
  check_parameters(points);
}

Tolerance absolute_tolerance(const ToleranceRequest& request, const ParameterizedPoints& points,
                             double diagonal, double rounding) {
  if (!(request.value > 0) || !std::isfinite(request.value))
    throw InvalidInput(fmt::format("the tolerance is {}: it must be positive and finite", request.value));
  if (row_of(request.measure).needs_share && !(request.share > 0 && request.share <= 1))
    throw InvalidInput(
        fmt::format("a share of {} % of the points: it must lie in (0, 100]", 100 * request.share));
  if (request.relative && !(diagonal > 0))
    throw InvalidInput(points.dimension == 1 ? "all values are equal, so a tolerance in % of their range "
                                               "means nothing; give it as an absolute value"
                                             : "all points are equal: there is no surface to fit");
  Tolerance t{request.relative ? request.value / 100 * diagonal : request.value, request.measure,
              request.share};
  if (t.measure == ErrorMeasure::percentile && t.share == 1) t.measure = ErrorMeasure::max;
  if (t.value < 16 * rounding)
    throw InvalidInput(
        fmt::format("the tolerance {} is below what coordinates of this size can hold in double "
                    "precision ({}); ask for a larger one, or move the data nearer to the origin",
                    t.value, 16 * rounding));
  return t;
}

Request make_request(const std::optional<ToleranceRequest>& tolerance, bool size_or_knots,
                     const ParameterizedPoints& points, double rounding, double unit) {
  if (!tolerance && !size_or_knots)
    throw InvalidInput("give a tolerance, a number of control points, or knots");
  Request request;
  request.searched = !size_or_knots;
  request.diagonal = bounding_diagonal(points);
  if (tolerance) request.asked = absolute_tolerance(*tolerance, points, request.diagonal, rounding);
  request.inside = request.asked;
  // Undoing the frame moves control points by up to an ulp of the data.
  request.inside.value = std::max(0.0, (request.asked.value * (1 - 1e-9) - 4 * rounding) / unit);
  return request;
}

void note_duplicates(const IndexedPoints& points, std::vector<std::string>& notes) {
  const Index shared = static_cast<Index>(points.distinct.of.size()) - points.distinct.size();
  if (shared > 0)
    notes.push_back(
        fmt::format("{} points have the same parameters as another: the surface goes between them", shared));
}

}  // namespace knotfit
