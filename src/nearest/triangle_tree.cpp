#include "nearest/triangle_tree.h"

#include <algorithm>
#include <numeric>

#include "base/narrow.h"
namespace knotfit {

std::array<double, 3> closest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double t = d1 - d3 > 0 ? d1 / (d1 - d3) : 0;
    return {1 - t, t, 0};
  }
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double t = d2 - d6 > 0 ? d2 / (d2 - d6) : 0;
    return {1 - t, 0, t};
  }
  const double va = d3 * d6 - d5 * d4, e = d4 - d3, f = d5 - d6;
  if (va <= 0 && e >= 0 && f >= 0) {
    const double t = e + f > 0 ? e / (e + f) : 0;
    return {0, 1 - t, t};
  }
  const double s = 1 / (va + vb + vc), v = vb * s, w = vc * s;
  return {1 - v - w, v, w};
}

namespace {

double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c,
                        const std::array<double, 3>& w) {
  return squared(w[0] * a + w[1] * b + w[2] * c - p);
}

double component(const Vec3& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

}  // namespace

TriangleTree::TriangleTree(std::span<const double> vertices, Faces faces) {
  const std::size_t n = faces.size();
  narrow(static_cast<Index>(n));
  order_.resize(n);
  std::iota(order_.begin(), order_.end(), 0);
  std::vector<Vec3> middle(n);
  std::vector<Corners> all(n);
  for (std::size_t f = 0; f < n; ++f) {
    all[f] = {at(&vertices[3 * faces[f][0]]), at(&vertices[3 * faces[f][1]]), at(&vertices[3 * faces[f][2]])};
    middle[f] = all[f].a + all[f].b + all[f].c;
  }
  corners_ = std::move(all);
  nodes_.reserve(n);
  build(0, static_cast<std::int32_t>(n), middle);
  std::vector<Corners> sorted(n);
  place_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    sorted[k] = corners_[order_[k]];
    place_[order_[k]] = static_cast<std::int32_t>(k);
  }
  corners_ = std::move(sorted);
}

std::int32_t TriangleTree::build(std::int32_t begin, std::int32_t end, std::span<const Vec3> middle) {
  const auto me = static_cast<std::int32_t>(nodes_.size());
  Node node{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, begin, end - begin};
  for (std::int32_t k = begin; k < end; ++k) {
    const Corners& c = corners_[order_[k]];
    for (int axis = 0; axis < 3; ++axis) {
      node.low[axis] =
          std::min({node.low[axis], component(c.a, axis), component(c.b, axis), component(c.c, axis)});
      node.high[axis] =
          std::max({node.high[axis], component(c.a, axis), component(c.b, axis), component(c.c, axis)});
    }
  }
  nodes_.push_back(node);
  if (end - begin <= 4) return me;
  int widest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (node.high[axis] - node.low[axis] > node.high[widest] - node.low[widest]) widest = axis;
  const std::int32_t half = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                   [&](std::int32_t a, std::int32_t b) {
                     const double x = component(middle[a], widest), y = component(middle[b], widest);
                     return x < y || (x == y && a < b);
                   });
  build(begin, half, middle);
  const std::int32_t right = build(half, end, middle);
  nodes_[me].first = right;
  nodes_[me].count = 0;
  return me;
}

double TriangleTree::distance(std::int32_t place, const Vec3& p) const {
  const Corners& c = corners_[place];
  return squared_distance(p, c.a, c.b, c.c, closest_weights(p, c.a, c.b, c.c));
}

TriangleHit TriangleTree::nearest(const Vec3& p, Index hint) const {
  TriangleHit hit;
  const auto look = [&](std::int32_t place) {
    const Corners& c = corners_[place];
    const std::array<double, 3> w = closest_weights(p, c.a, c.b, c.c);
    const double d = squared_distance(p, c.a, c.b, c.c, w);
    if (d < hit.squared || (d == hit.squared && order_[place] < hit.face)) hit = {d, order_[place], w};
  };
  if (hint >= 0) look(place_[hint]);
  walk(
      p, [&] { return hit.squared; }, look);
  return hit;
}

}  // namespace knotfit
