// Closest triangles by a tree of boxes.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "knotfit/index.h"
namespace knotfit {

struct TriangleHit {
  double squared = std::numeric_limits<double>::infinity();
  Index face = -1;
  std::array<double, 3> weight{};  ///< of the corners, for the closest point
};

/// Weights of the corners for the point of the triangle closest to p [Ericson05 5.1.5].
std::array<double, 3> closest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

class TriangleTree {
 public:
  using Faces = std::span<const std::array<std::int32_t, 3>>;
  /// \param vertices  n x 3   \param faces  at least one
  TriangleTree(std::span<const double> vertices, Faces faces);

  /// The closest triangle. Among equally near ones it is always the same.
  /// \param hint  a face near p, looked at first; -1: none
  TriangleHit nearest(const Vec3& p, Index hint = -1) const;

  /// Calls visit(face, squared distance) for every triangle at most bound() away. \param bound  a function, asked again
  /// and again: it may shrink
  template <class Bound, class Visit>
  void within(const Vec3& p, const Bound& bound, const Visit& visit) const {
    const auto most = [&] {
      const double far = bound();
      return far * far;
    };
    walk(p, most, [&](std::int32_t place) { visit(order_[place], distance(place, p)); });
  }

 private:
  struct Node {
    double low[3], high[3];
    std::int32_t first = 0,
                 count = 0;  ///< of a leaf: its triangles; else count is 0, and first the right child
  };
  struct Corners {
    Vec3 a, b, c;
  };
  static double box_distance(const Node& n, const Vec3& p) {
    const double x = std::max({n.low[0] - p.x, 0.0, p.x - n.high[0]});
    const double y = std::max({n.low[1] - p.y, 0.0, p.y - n.high[1]});
    const double z = std::max({n.low[2] - p.z, 0.0, p.z - n.high[2]});
    return x * x + y * y + z * z;
  }
  /// Calls leaf(place) for the triangles of all boxes whose squared distance is at most most(), the nearer box first.
  template <class Most, class Leaf>
  void walk(const Vec3& p, const Most& most, const Leaf& leaf) const {
    std::array<std::int32_t, 128> stack;
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const auto number = stack[--top];
      const Node& node = nodes_[number];
      if (box_distance(node, p) > most()) continue;
      if (node.count > 0) {
        for (std::int32_t k = node.first; k < node.first + node.count; ++k) leaf(k);
        continue;
      }
      const auto left = number + 1, right = node.first;
      const bool left_first = box_distance(nodes_[left], p) <= box_distance(nodes_[right], p);
      stack[top++] = left_first ? right : left;
      stack[top++] = left_first ? left : right;
    }
  }
  double distance(std::int32_t place, const Vec3& p) const;
  std::int32_t build(std::int32_t begin, std::int32_t end, std::span<const Vec3> middle);

  std::vector<Node> nodes_;
  std::vector<std::int32_t> order_;  ///< face at each place
  std::vector<std::int32_t> place_;  ///< of each face
  std::vector<Corners> corners_;     ///< by place
};

}  // namespace knotfit
