#include "parameterize/cloud_base.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
namespace knotfit::cloud {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

constexpr double kLine = 1e-10;  // of the largest variance: what digits in a file leave of a straight line

Vector3d at(std::span<const double> points, Index k) {
  return {points[3 * k], points[3 * k + 1], points[3 * k + 2]};
}

Vector3d vector_of(const Vector& v) {
  return {v[0], v[1], v[2]};
}
Vector array_of(const Vector3d& v) {
  return {v[0], v[1], v[2]};
}

/// Convex hull, counter-clockwise [Andrew79].
std::vector<Vector2d> hull_of(std::vector<Vector2d> p) {
  std::sort(p.begin(), p.end(),
            [](const Vector2d& a, const Vector2d& b) { return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1]; });
  std::vector<Vector2d> hull(2 * p.size());
  std::size_t n = 0;
  const auto turns = [&](const Vector2d& c) {
    const Vector2d a = hull[n - 1] - hull[n - 2], b = c - hull[n - 2];
    return a[0] * b[1] - a[1] * b[0] > 0;
  };
  for (std::size_t k = 0; k < p.size(); ++k) {
    while (n >= 2 && !turns(p[k])) --n;
    hull[n++] = p[k];
  }
  for (std::size_t k = p.size() - 1, least = n + 1; k-- > 0;) {
    while (n >= least && !turns(p[k])) --n;
    hull[n++] = p[k];
  }
  hull.resize(n > 1 ? n - 1 : n);
  return hull;
}

/// Direction of the longer side of the rectangle of least area: one of its sides lies on the hull [Freeman75].
Vector2d rectangle_side(const std::vector<Vector2d>& points) {
  const std::vector<Vector2d> hull = hull_of(points);
  double least = INFINITY;
  Vector2d best(1, 0);
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vector2d edge = hull[(k + 1) % hull.size()] - hull[k];
    if (!(edge.norm() > 0)) continue;
    const Vector2d along = edge.normalized(), across(-along[1], along[0]);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (const Vector2d& p : hull)
      for (int c = 0; c < 2; ++c) {
        const double x = p.dot(c == 0 ? along : across);
        low[c] = std::min(low[c], x), high[c] = std::max(high[c], x);
      }
    const double width = high[0] - low[0], height = high[1] - low[1];
    // Of equal areas the first; rounding must not choose.
    if (width * height < least * (1 - 1e-9)) {
      least = width * height;
      best = width >= height ? along : across;
    }
  }
  return best[0] < 0 || (best[0] == 0 && best[1] < 0) ? Vector2d(-best) : best;
}

/// The axis' sign by its largest component, so that z is up where the points lie flat.
Vector3d turned_up(const Vector3d& axis) {
  int largest = 2;
  for (int c = 1; c >= 0; --c)
    if (std::abs(axis[c]) > std::abs(axis[largest]) * (1 + 1e-9)) largest = c;
  return axis[largest] < 0 ? Vector3d(-axis) : axis;
}

void frame_of(const Vector3d& axis, Vector3d& first, Vector3d& second) {
  const auto [a, b] = cloud::frame_of(array_of(axis));
  first = vector_of(a);
  second = vector_of(b);
}

}  // namespace

BasePlaces project_to_plane(std::span<const double> points) {
  const Axes axes = principal_axes(points);
  if (!(axes.variance[2] > 0)) throw InvalidInput("all points are at one place: there is no surface to fit");
  if (!(axes.variance[1] > kLine * axes.variance[2]))
    throw InvalidInput("all points lie on one straight line: there is no plane to project them to");
  const Vector3d normal = turned_up(vector_of(axes.axis[0]));
  const Vector3d centre = vector_of(axes.centre);
  Vector3d first, second;
  frame_of(normal, first, second);
  const Index n = static_cast<Index>(points.size()) / 3;
  std::vector<Vector2d> flat;
  for (Index k = 0; k < n; ++k) {
    const Vector3d p = at(points, k) - centre;
    flat.emplace_back(p.dot(first), p.dot(second));
  }
  const Vector2d side = rectangle_side(flat);
  BasePlaces places;
  places.centre = axes.centre;
  places.axis = array_of(normal);
  places.scatter = std::sqrt(std::max(0.0, axes.variance[0]));
  for (const Vector2d& p : flat) {
    places.at.push_back(p.dot(side));
    places.at.push_back(p[1] * side[0] - p[0] * side[1]);
  }
  return places;
}

BasePlaces project_to_cylinder(std::span<const double> points, const std::vector<Vector>& normals) {
  const Index n = static_cast<Index>(points.size()) / 3;
  const Axes axes = principal_axes(points);
  const Vector3d centre = vector_of(axes.centre);
  const double size = std::sqrt(axes.variance[0] + axes.variance[1] + axes.variance[2]);
  if (!(axes.variance[1] > kLine * axes.variance[2]))
    throw InvalidInput("all points lie on one straight line: there is no cylinder to project them to");
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (const Vector& v : normals) {
    const Vector3d x = vector_of(v);
    m += x * x.transpose();
  }
  Vector3d axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvectors().col(0);
  // A circle around the projections along the axis: |p|^2 = 2 c.p + d, linear least squares [Kasa76].
  Vector3d first, second;
  frame_of(axis, first, second);
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  for (Index k = 0; k < n; ++k) {
    const Vector3d p = (at(points, k) - centre) / size;
    const Vector3d row(2 * p.dot(first), 2 * p.dot(second), 1);
    a += row * row.transpose();
    b += row * (row[0] * row[0] + row[1] * row[1]) / 4;
  }
  const Vector3d circle = a.ldlt().solve(b);
  Vector3d through = centre + size * (circle[0] * first + circle[1] * second);
  double radius = size * std::sqrt(std::max(0.0, circle[2] + circle[0] * circle[0] + circle[1] * circle[1]));
  // Gauss-Newton on the distances: the axis' place and direction (two numbers each) and the radius.
  double scatter = INFINITY;
  for (int round = 0; round < 50 && std::isfinite(radius); ++round) {
    frame_of(axis, first, second);
    Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
    Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
    double square = 0;
    for (Index k = 0; k < n; ++k) {
      const Vector3d p = at(points, k) - through;
      const double x = p.dot(first), y = p.dot(second), z = p.dot(axis), r = std::hypot(x, y);
      if (!(r > 0)) continue;
      Eigen::Matrix<double, 5, 1> row;
      row << -x / r, -y / r, -z * x / r / size, -z * y / r / size, -1;
      const double off = r - radius;
      normal += row * row.transpose();
      right -= row * off;
      square += off * off;
    }
    const double now = std::sqrt(square / static_cast<double>(n));
    if (!(now < scatter * (1 - 1e-9))) break;
    scatter = now;
    for (int c = 0; c < 5; ++c) normal(c, c) *= 1 + 1e-9;
    const Eigen::Matrix<double, 5, 1> step = normal.ldlt().solve(right);
    if (!step.allFinite()) break;
    through += step[0] * first + step[1] * second;
    axis = (axis + (step[2] * first + step[3] * second) / size).normalized();
    radius = std::abs(radius + step[4]);
  }
  if (!(radius < 100 * size) || !(scatter < 0.2 * radius))
    throw InvalidInput("the points lie on no cylinder: " + remedy_text(Remedy::base, "plane") +
                       " suits them better");
  axis = turned_up(axis);
  through += (centre - through).dot(axis) * axis;  // beside the centre of the points
  frame_of(axis, first, second);
  std::vector<double> angle;
  for (Index k = 0; k < n; ++k) {
    const Vector3d p = at(points, k) - through;
    angle.push_back(std::atan2(p.dot(second), p.dot(first)));
  }
  std::vector<double> sorted = angle;
  std::sort(sorted.begin(), sorted.end());
  double cut = sorted.front(), gap = sorted.front() + 2 * std::numbers::pi - sorted.back();
  for (std::size_t k = 1; k < sorted.size(); ++k)
    if (sorted[k] - sorted[k - 1] > gap) gap = sorted[k] - sorted[k - 1], cut = sorted[k];
  BasePlaces places;
  places.centre = array_of(through);
  places.axis = array_of(axis);
  places.radius = radius;
  places.scatter = scatter;
  for (Index k = 0; k < n; ++k) {
    const double from_cut = angle[k] < cut ? angle[k] - cut + 2 * std::numbers::pi : angle[k] - cut;
    places.at.push_back(radius * from_cut);
    places.at.push_back((at(points, k) - through).dot(axis));
  }
  return places;
}

void turn_to_normals(BasePlaces& places, std::span<const double> points, std::span<const double> given) {
  const Vector3d axis = vector_of(places.axis), centre = vector_of(places.centre);
  const bool cylinder = places.radius > 0;
  Index sides = 0;
  for (Index k = 0; k < static_cast<Index>(given.size()) / 3; ++k) {
    const Vector3d off = at(points, k) - centre;
    const double side = at(given, k).dot(cylinder ? Vector3d(off - off.dot(axis) * axis) : axis);
    sides += (side > 0) - (side < 0);
  }
  if (sides >= 0) return;
  if (!cylinder) places.axis = array_of(-axis);
  for (std::size_t k = cylinder ? 1 : 0; k < places.at.size(); k += 2) places.at[k] = -places.at[k];
}

}  // namespace knotfit::cloud
