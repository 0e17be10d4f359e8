#include "parameterize/delaunay.h"

#include <algorithm>
#include <numeric>
namespace knotfit::cloud {
namespace {

__extension__ using Wide = __int128;

constexpr std::int32_t kNone = -1, kFar = -1;  // no triangle; the vertex at infinity beyond the hull

/// d is inside the circle through a, b, c (counter-clockwise). Differences have 30 bits, squares 61, the sum 124.
bool in_circle(const Place& a, const Place& b, const Place& c, const Place& d) {
  const std::int64_t ax = a[0] - d[0], ay = a[1] - d[1], bx = b[0] - d[0], by = b[1] - d[1], cx = c[0] - d[0],
                     cy = c[1] - d[1];
  const auto lifted = [](std::int64_t x, std::int64_t y) { return Wide(x * x + y * y); };
  return lifted(ax, ay) * (bx * cy - by * cx) + lifted(bx, by) * (cx * ay - cy * ax) +
             lifted(cx, cy) * (ax * by - ay * bx) >
         0;
}

/// Place on the Morton curve.
std::uint64_t curve_key(const Place& p) {
  const auto spread = [](std::int64_t x) {
    auto v = static_cast<std::uint64_t>(x) & 0xffffffff;
    v = (v | v << 16) & 0x0000ffff0000ffff;
    v = (v | v << 8) & 0x00ff00ff00ff00ff;
    v = (v | v << 4) & 0x0f0f0f0f0f0f0f0f;
    v = (v | v << 2) & 0x3333333333333333;
    return (v | v << 1) & 0x5555555555555555;
  };
  return spread(p[0]) | spread(p[1]) << 1;
}

/// Triangles and, beyond each edge of the hull, one with the vertex at infinity.
class Builder {
 public:
  explicit Builder(const std::vector<Place>& places) : place_(places), fan_(places.size() + 1, kNone) {}

  Triangulation build() {
    Triangulation result;
    result.used.assign(place_.size(), 1);
    std::vector<std::int32_t> order = distinct_in_order(result.used);
    if (!begin(order)) return result;
    for (const std::int32_t p : order)
      if (p >= 0) insert(p);
    std::vector<std::int32_t> number(corner_.size(), kNone);
    for (std::size_t t = 0; t < corner_.size(); ++t)
      if (alive_[t] && !far(t)) {
        number[t] = static_cast<std::int32_t>(result.triangle.size());
        result.triangle.push_back(corner_[t]);
      }
    for (std::size_t t = 0; t < corner_.size(); ++t)
      if (number[t] != kNone)
        result.beside.push_back({number[beside_[t][0]], number[beside_[t][1]], number[beside_[t][2]]});
    return result;
  }

 private:
  using Triple = std::array<std::int32_t, 3>;

  std::vector<std::int32_t> distinct_in_order(std::vector<char>& used) const {
    std::vector<std::int32_t> order(place_.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::uint64_t> key(place_.size());
    for (std::size_t k = 0; k < key.size(); ++k) key[k] = curve_key(place_[k]);
    std::sort(order.begin(), order.end(),
              [&](std::int32_t a, std::int32_t b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
    const auto end = std::unique(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      if (place_[a] != place_[b]) return false;
      used[b] = 0;
      return true;
    });
    order.erase(end, order.end());
    return order;
  }

  /// The first triangle, from the first three places that are not on one line; they are marked as done.
  bool begin(std::vector<std::int32_t>& order) {
    if (order.size() < 3) return false;
    std::size_t third = 2;
    while (third < order.size() && area(place_[order[0]], place_[order[1]], place_[order[third]]) == 0)
      ++third;
    if (third == order.size()) return false;
    std::int32_t a = order[0], b = order[1], c = order[third];
    if (area(place_[a], place_[b], place_[c]) < 0) std::swap(b, c);
    corner_ = {{a, b, c}, {b, a, kFar}, {c, b, kFar}, {a, c, kFar}};
    beside_ = {{2, 3, 1}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}};
    alive_.assign(4, 1);
    order[0] = order[1] = order[third] = kNone;
    return true;
  }

  bool far(std::size_t t) const { return corner_[t][2] == kFar; }  // always the last corner

  bool conflicts(std::int32_t t, const Place& p) const {
    const Triple& c = corner_[t];
    const Place &a = place_[c[0]], &b = place_[c[1]];
    if (!far(t)) return in_circle(a, b, place_[c[2]], p);
    const std::int64_t side = area(a, b, p);
    if (side != 0) return side > 0;
    return (p[0] - a[0]) * (b[0] - p[0]) + (p[1] - a[1]) * (b[1] - p[1]) > 0;
  }

  /// A triangle in conflict with p, by a walk towards it.
  std::int32_t find(const Place& p) const {
    std::int32_t t = far(last_) ? beside_[last_][2] : last_;
    for (;;) {
      if (far(t)) return t;
      const Triple& c = corner_[t];
      int k = 0;
      while (k < 3 && area(place_[c[(k + 1) % 3]], place_[c[(k + 2) % 3]], p) >= 0) ++k;
      if (k == 3) return t;
      t = beside_[t][k];
    }
  }

  std::int32_t add(const Triple& corners) {
    if (free_.empty()) {
      corner_.push_back(corners);
      beside_.push_back({kNone, kNone, kNone});
      alive_.push_back(1);
      return static_cast<std::int32_t>(corner_.size()) - 1;
    }
    const std::int32_t t = free_.back();
    free_.pop_back();
    corner_[t] = corners;
    alive_[t] = 1;
    return t;
  }

  void insert(std::int32_t vertex) {
    const Place& p = place_[vertex];
    cavity_.assign(1, find(p));
    alive_[cavity_[0]] = 0;
    rim_.clear();
    for (std::size_t k = 0; k < cavity_.size(); ++k) {
      const std::int32_t t = cavity_[k];
      for (int side = 0; side < 3; ++side) {
        const std::int32_t other = beside_[t][side];
        if (alive_[other] == 0) continue;
        if (conflicts(other, p)) {
          alive_[other] = 0;
          cavity_.push_back(other);
        } else {
          rim_.push_back({corner_[t][(side + 1) % 3], corner_[t][(side + 2) % 3], other});
        }
      }
    }
    // A triangle from p to every edge of the rim; neighbours meet at the rim's vertices.
    added_.clear();
    for (const auto& [a, b, other] : rim_) {
      Triple corners{a, b, vertex};
      if (a == kFar) corners = {b, vertex, kFar};
      if (b == kFar) corners = {vertex, a, kFar};
      const std::int32_t t = add(corners);
      added_.push_back(t);
      fan_[a + 1] = t;  // the triangle whose edge begins at a
      set_beside(t, a, b, other);
      set_beside(other, b, a, t);
    }
    for (std::size_t k = 0; k < rim_.size(); ++k) {
      const auto& [a, b, other] = rim_[k];
      set_beside(added_[k], b, vertex, fan_[b + 1]);
      set_beside(fan_[b + 1], vertex, b, added_[k]);
    }
    for (const std::int32_t t : cavity_) free_.push_back(t);
    last_ = added_.back();
  }

  /// What is beside the edge from a to b of t.
  void set_beside(std::int32_t t, std::int32_t a, std::int32_t b, std::int32_t other) {
    for (int k = 0; k < 3; ++k)
      if (corner_[t][(k + 1) % 3] == a && corner_[t][(k + 2) % 3] == b) beside_[t][k] = other;
  }

  const std::vector<Place>& place_;
  std::vector<Triple> corner_, beside_;
  std::vector<char> alive_;
  std::vector<std::int32_t> free_, cavity_, added_, fan_;
  std::vector<Triple> rim_;
  std::int32_t last_ = 0;
};

}  // namespace

std::int64_t area(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

Triangulation delaunay(const std::vector<Place>& places) {
  return Builder(places).build();
}

}  // namespace knotfit::cloud
