// Points of the drawing (2D, y down) and of the scene (3D).
#pragma once
#include <algorithm>
#include <cmath>
namespace knotfit::report {

struct Vec2 {
  double x = 0, y = 0;
};
inline Vec2 operator+(Vec2 a, Vec2 b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vec2 operator-(Vec2 a, Vec2 b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vec2 operator*(double s, Vec2 a) {
  return {s * a.x, s * a.y};
}
inline double length(Vec2 a) {
  return std::hypot(a.x, a.y);
}

struct Vec3 {
  double x = 0, y = 0, z = 0;
};
inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(double s, Vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) {
  return std::hypot(a.x, a.y, a.z);
}
/// a / |a|, or `otherwise` where a is zero or not finite.
inline Vec3 unit_or(Vec3 a, Vec3 otherwise) {
  const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return otherwise;
  const Vec3 scaled{a.x / largest, a.y / largest, a.z / largest};  // |a|^2 may leave the range of doubles
  return (1 / length(scaled)) * scaled;
}

/// A rectangle of the drawing, y down.
struct Box {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
  Vec2 centre() const { return {x + width / 2, y + height / 2}; }
  bool contains(const Box& b, double slack = 0) const {
    return b.x >= x - slack && b.y >= y - slack && b.right() <= right() + slack &&
           b.bottom() <= bottom() + slack;
  }
  bool overlaps(const Box& b) const {
    return b.x < right() && x < b.right() && b.y < bottom() && y < b.bottom();
  }
};

}  // namespace knotfit::report
