#include "knotfit/mesh_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "data/mesh_data.h"
#include "data/mesh_topology.h"
#include "data/orientation.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

constexpr double kRounding = 1e-6;   // of the range of the parameters: six digits
constexpr double kMostFlat = 1e-3;   // of the area in space that may have none in the plane
constexpr double kSamePlace = 1e-7;  // of the diagonal
constexpr Index kMostEntries = 64;   // of a triangle in the grid of cells, on average
constexpr Index kMostTests = 256;    // of pairs a triangle, on average

using Place = std::array<double, 2>;
using Triangle = std::array<Place, 3>;

double longest_side(const Triangle& t) {
  double longest = 0;
  for (int k = 0; k < 3; ++k)
    longest = std::max(longest, std::hypot(t[(k + 1) % 3][0] - t[k][0], t[(k + 1) % 3][1] - t[k][1]));
  return longest;
}

/// Least and largest product with the axis.
std::pair<double, double> shadow(const Triangle& t, const Place& axis) {
  double low = INFINITY, high = -INFINITY;
  for (const Place& p : t) {
    const double x = p[0] * axis[0] + p[1] * axis[1];
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return {low, high};
}

/// Triangles whose shadows overlap by more than rounding on every normal of their sides share an area.
bool overlap(const Triangle& a, const Triangle& b) {
  for (const Triangle* t : {&a, &b})
    for (int k = 0; k < 3; ++k) {
      const Place &p = (*t)[k], &q = (*t)[(k + 1) % 3];
      const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
      if (!(length > 0)) return false;
      const Place axis{(q[1] - p[1]) / length, (p[0] - q[0]) / length};
      const auto [low_a, high_a] = shadow(a, axis);
      const auto [low_b, high_b] = shadow(b, axis);
      if (std::min(high_a, high_b) - std::max(low_a, low_b) <= kRounding) return false;
    }
  return true;
}

struct Box {
  Place low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  explicit Box(const Triangle& t) {
    for (const Place& p : t)
      for (int d = 0; d < 2; ++d) {
        low[d] = std::min(low[d], p[d]);
        high[d] = std::max(high[d], p[d]);
      }
  }
};

/// Triangles over [0,1]^2 by the cells of a grid that their boxes touch.
class Cells {
 public:
  explicit Cells(const std::vector<Triangle>& triangles) : triangles_(triangles) {
    Place mean{0, 0};
    for (const Triangle& t : triangles) {
      boxes_.emplace_back(t);
      for (int d = 0; d < 2; ++d)
        mean[d] += (boxes_.back().high[d] - boxes_.back().low[d]) / static_cast<double>(triangles.size());
    }
    const auto n = static_cast<double>(triangles.size());
    Place wanted{};
    for (int d = 0; d < 2; ++d) wanted[d] = std::clamp(1 / std::max(mean[d], 1 / n), 1.0, n);
    const double shrink = std::sqrt(std::max(1.0, wanted[0] * wanted[1] / (2 * n + 16)));
    for (int d = 0; d < 2; ++d) count_[d] = std::max<Index>(1, static_cast<Index>(wanted[d] / shrink));
    while (entries() > kMostEntries * static_cast<Index>(triangles.size()) && count_[0] * count_[1] > 1)
      for (Index& count : count_) count = std::max<Index>(1, count / 2);
    fill();
  }

  /// The first two triangles found to overlap, in the order of the cells.
  std::optional<std::pair<Index, Index>> find_overlap() const {
    Index tests = 0;
    const Index most = kMostTests * static_cast<Index>(triangles_.size()) + 10'000'000;
    for (Index cell = 0; cell < count_[0] * count_[1]; ++cell)
      for (Index i = start_[cell]; i < start_[cell + 1]; ++i)
        for (Index j = i + 1; j < start_[cell + 1]; ++j) {
          if (++tests > most) return std::nullopt;
          const Index a = member_[i], b = member_[j];
          if (first_common_cell(a, b) == cell && overlap(triangles_[a], triangles_[b]))
            return std::pair(a, b);
        }
    return std::nullopt;
  }

 private:
  Index index(double x, int d) const {
    return std::clamp<Index>(static_cast<Index>(x * static_cast<double>(count_[d])), 0, count_[d] - 1);
  }
  Index entries() const {
    Index sum = 0;
    for (const Box& b : boxes_)
      sum += (index(b.high[0], 0) - index(b.low[0], 0) + 1) * (index(b.high[1], 1) - index(b.low[1], 1) + 1);
    return sum;
  }
  template <class Visit>
  void each_entry(const Visit& visit) const {
    for (std::size_t t = 0; t < boxes_.size(); ++t)
      for (Index i = index(boxes_[t].low[0], 0); i <= index(boxes_[t].high[0], 0); ++i)
        for (Index j = index(boxes_[t].low[1], 1); j <= index(boxes_[t].high[1], 1); ++j)
          visit(i * count_[1] + j, static_cast<Index>(t));
  }
  void fill() {
    start_.assign(static_cast<std::size_t>(count_[0] * count_[1] + 1), 0);
    each_entry([&](Index cell, Index) { ++start_[cell + 1]; });
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    member_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<Index> next(start_.begin(), start_.end() - 1);
    each_entry([&](Index cell, Index t) { member_[next[cell]++] = t; });
  }
  /// Of both boxes; -1 where they do not overlap by more than rounding. A pair is looked at in that cell alone.
  Index first_common_cell(Index a, Index b) const {
    Place low{};
    for (int d = 0; d < 2; ++d) {
      low[d] = std::max(boxes_[a].low[d], boxes_[b].low[d]);
      if (std::min(boxes_[a].high[d], boxes_[b].high[d]) - low[d] <= kRounding) return -1;
    }
    return index(low[0], 0) * count_[1] + index(low[1], 1);
  }

  const std::vector<Triangle>& triangles_;
  std::vector<Box> boxes_;
  Index count_[2] = {1, 1};
  std::vector<Index> start_, member_;
};

class Checker {
 public:
  explicit Checker(const Mesh& mesh) : mesh_(mesh), used_(static_cast<std::size_t>(mesh.vertex_count()), 0) {
    for (Index f = 0; f < mesh.face_count(); ++f) {
      if (!is_data(mesh, f)) continue;
      for (const std::int32_t v : mesh.faces[f]) used_[v] = 1;
      if (!is_degenerate(mesh, f)) faces_.push_back(f);
    }
  }

  std::string why() {
    if (std::string reason = missing(); !reason.empty()) return reason;
    if (std::string reason = without_extent(); !reason.empty()) return reason;
    scale();
    if (std::string reason = on_a_line(); !reason.empty()) return reason;
    if (std::string reason = turned(); !reason.empty()) return reason;
    if (std::string reason = shared_places(); !reason.empty()) return reason;
    if (triangles_.empty()) return "";
    const auto found = Cells(triangles_).find_overlap();
    if (!found) return "";
    return fmt::format("triangles of the faces {} and {} (counted from {}) cover each other",
                       number_of_face(faces_[found->first]), number_of_face(faces_[found->second]),
                       mesh_.counted_from);
  }

 private:
  Index number_of_face(Index f) const {
    return (mesh_.face_source.empty() ? f : mesh_.face_source[f]) + mesh_.counted_from;
  }
  Index number_of_vertex(Index v) const {
    return (mesh_.vertex_source.empty() ? v : mesh_.vertex_source[v]) + mesh_.counted_from;
  }

  std::string missing() const {
    Index count = 0;
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      count += used_[v] && !(std::isfinite(mesh_.uv[2 * v]) && std::isfinite(mesh_.uv[2 * v + 1]));
    if (count == 0) return "";
    return fmt::format("{} of the vertices {} none that {} finite", count, count == 1 ? "has" : "have",
                       count == 1 ? "is" : "are");
  }

  std::string without_extent() {
    low_ = {INFINITY, INFINITY};
    high_ = {-INFINITY, -INFINITY};
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      for (int d = 0; d < 2 && used_[v]; ++d) {
        low_[d] = std::min(low_[d], mesh_.uv[2 * v + d]);
        high_[d] = std::max(high_[d], mesh_.uv[2 * v + d]);
      }
    const bool flat_u = !(high_[0] > low_[0]), flat_v = !(high_[1] > low_[1]);
    if (flat_u && flat_v)
      return fmt::format("they are equal at all vertices, u = {} and v = {}", low_[0], low_[1]);
    if (flat_u) return fmt::format("they lie on a line, u = {} at all vertices", low_[0]);
    if (flat_v) return fmt::format("they lie on a line, v = {} at all vertices", low_[1]);
    return "";
  }

  Place at(Index v) const {
    Place p{};
    for (int d = 0; d < 2; ++d)
      p[d] = mesh_.uv[2 * v + d] / (high_[d] - low_[d]) - low_[d] / (high_[d] - low_[d]);
    return p;
  }

  void scale() {
    triangles_.reserve(faces_.size());
    for (const Index f : faces_) {
      const auto& c = mesh_.faces[f];
      triangles_.push_back({at(c[0]), at(c[1]), at(c[2])});
    }
  }

  /// A line that is neither u nor v: every triangle is flat, and the whole too.
  std::string on_a_line() const {
    double longest = 0;
    Place from{}, to{};
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (used_[v] && std::abs(at(v)[0] - 0.5) > longest) longest = std::abs(at(v)[0] - 0.5), from = at(v);
    longest = 0;
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      const double length = used_[v] ? std::hypot(at(v)[0] - from[0], at(v)[1] - from[1]) : 0;
      if (length > longest) longest = length, to = at(v);
    }
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (used_[v] && std::abs(twice_area(from.data(), to.data(), at(v).data())) > 10 * kRounding * longest)
        return "";
    return "they lie on a line";
  }

  std::string turned() {
    Index left = 0, right = 0, flat = 0;
    double area = 0, flat_area = 0;
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
      const Triangle& t = triangles_[k];
      const double doubled = twice_area(t[0].data(), t[1].data(), t[2].data()),
                   own = face_area(mesh_, faces_[k]);
      area += own;
      if (std::abs(doubled) <= kRounding * longest_side(t))
        ++flat, flat_area += own;
      else
        ++(doubled > 0 ? left : right);
    }
    const Index n = static_cast<Index>(triangles_.size());
    if (const Index fewer = std::min(left, right); fewer > 0)
      return fmt::format("{} of {} triangles are mirrored", fewer, n);
    if (flat_area > kMostFlat * area) return fmt::format("{} of {} triangles have no area in them", flat, n);
    return "";
  }

  std::string shared_places() const {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    std::vector<Index> order;
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (!used_[v]) continue;
      order.push_back(v);
      for (int d = 0; d < 3; ++d) {
        low[d] = std::min(low[d], mesh_.vertex(v)[d]);
        high[d] = std::max(high[d], mesh_.vertex(v)[d]);
      }
    }
    const double* uv = mesh_.uv.data();
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      if (uv[2 * a] != uv[2 * b]) return uv[2 * a] < uv[2 * b];
      return uv[2 * a + 1] != uv[2 * b + 1] ? uv[2 * a + 1] < uv[2 * b + 1] : a < b;
    });
    const double same = kSamePlace * std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    Index shared = 0, first = -1;
    for (std::size_t k = 1; k < order.size(); ++k) {
      const Index a = order[k - 1], b = order[k];
      if (uv[2 * a] != uv[2 * b] || uv[2 * a + 1] != uv[2 * b + 1]) continue;
      const double *p = mesh_.vertex(a), *q = mesh_.vertex(b);
      if (std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= same) continue;
      if (shared++ == 0) first = static_cast<Index>(k);
    }
    if (shared == 0) return "";
    return fmt::format(
        "{} vertices have those of another vertex elsewhere, such as {} and {} (counted from {})", shared,
        number_of_vertex(order[first - 1]), number_of_vertex(order[first]), mesh_.counted_from);
  }

  const Mesh& mesh_;
  std::vector<char> used_;
  std::vector<Index> faces_;  // with an area, none of them virtual
  Place low_{}, high_{};
  std::vector<Triangle> triangles_;  // of those faces, the range of u and v scaled to [0,1]
};

}  // namespace

ParameterCheck check_parameters(const Mesh& mesh) {
  if (static_cast<Index>(mesh.uv.size()) != 2 * mesh.vertex_count())
    throw InvalidInput(fmt::format("{} parameters for {} vertices: two each are needed", mesh.uv.size(),
                                   mesh.vertex_count()));
  const MeshTopology sound(mesh);  // throws where corners or coordinates are not
  std::string why = Checker(mesh).why();
  return {why.empty(), std::move(why)};
}

}  // namespace knotfit
