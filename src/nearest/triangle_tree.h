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

  /// The closest triangle; of equally near ones any, but always the same.
  /// \param hint  a face near p, to begin with; -1: none
  TriangleHit nearest(const Vec3& p, Index hint = -1) const;

  /// Calls visit(face, squared distance) for every triangle whose distance is at most the bound. \param bound
  /// a function, asked again and again as it may shrink: the distance (not squared) still of interest
  template <class Bound, class Visit>
  void within(const Vec3& p, const Bound& bound, const Visit& visit) const {
    std::array<std::int32_t, 128> stack;
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const Node& node = nodes_[stack[--top]];
      const double far = bound();
      if (box_distance(node, p) > far * far) continue;
      if (node.count > 0) {
        for (std::int32_t k = node.first; k < node.first + node.count; ++k) visit(order_[k], distance(k, p));
        continue;
      }
      push_both(node, p, stack, top);
    }
  }

 private:
  struct Node {
    double low[3], high[3];
    std::int32_t first = 0, count = 0;  ///< leaf: triangles; else count 0, first the right child
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
  template <class Stack>
  void push_both(const Node& node, const Vec3& p, Stack& stack, int& top) const {
    const auto left = static_cast<std::int32_t>(&node - nodes_.data()) + 1, right = node.first;
    if (box_distance(nodes_[left], p) <= box_distance(nodes_[right], p)) {
      stack[top++] = right;
      stack[top++] = left;
    } else {
      stack[top++] = left;
      stack[top++] = right;
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
