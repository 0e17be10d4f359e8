// Faces of no area: needles lose an edge, caps give their corner to the neighbour.
#include <algorithm>
#include <cmath>
#include <deque>

#include "data/mesh_edit.h"
#include "data/mesh_topology.h"
namespace knotfit {
namespace {

constexpr double kSamePlace = 1e-14;  // of the longest side: a needle, not a cap

class Dropper {
 public:
  explicit Dropper(Mesh& mesh)
      : mesh_(mesh), around_(static_cast<std::size_t>(mesh.vertex_count())), dead_(mesh.faces.size(), 0) {}

  Index run() {
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      attach(static_cast<std::int32_t>(f));
      if (is_degenerate(mesh_, f)) queue_.push_back(static_cast<std::int32_t>(f));
    }
    // Caps side by side may hand corners to and fro: after so many steps the rest is only dropped.
    splits_left_ = 8 * queue_.size() + 64;
    while (!queue_.empty()) {
      const std::int32_t f = queue_.front();
      queue_.pop_front();
      if (dead_[f] || !is_degenerate(mesh_, f)) continue;
      resolve(f);
    }
    std::vector<char> keep(dead_.size());
    std::transform(dead_.begin(), dead_.end(), keep.begin(), [](char dead) { return !dead; });
    keep_faces(mesh_, keep);
    return dropped_;
  }

 private:
  const std::array<std::int32_t, 3>& corners(std::int32_t f) const { return mesh_.faces[f]; }
  void attach(std::int32_t f) {
    const auto& c = corners(f);
    for (int k = 0; k < 3; ++k)
      if (std::find(c.begin(), c.begin() + k, c[k]) == c.begin() + k) around_[c[k]].push_back(f);
  }
  void detach(std::int32_t f) {
    for (const std::int32_t v : corners(f)) std::erase(around_[v], f);
  }
  void drop(std::int32_t f) {
    detach(f);
    dead_[f] = 1;
    ++dropped_;
  }
  double length(std::int32_t a, std::int32_t b) const {
    const double *p = mesh_.vertex(a), *q = mesh_.vertex(b);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  bool has(std::int32_t f, std::int32_t v) const {
    const auto& c = corners(f);
    return c[0] == v || c[1] == v || c[2] == v;
  }
  std::vector<std::int32_t> faces_on(std::int32_t a, std::int32_t b) const {
    std::vector<std::int32_t> out;
    for (const std::int32_t f : around_[a])
      if (has(f, b)) out.push_back(f);
    return out;
  }
  std::vector<std::int32_t> neighbours(std::int32_t v) const {
    std::vector<std::int32_t> out;
    for (const std::int32_t f : around_[v])
      for (const std::int32_t w : corners(f))
        if (w != v) out.push_back(w);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }
  bool on_border(std::int32_t v) const {
    for (const std::int32_t w : neighbours(v))
      if (faces_on(v, w).size() == 1) return true;
    return false;
  }

  /// Collapsing edge ab keeps the mesh manifold (link condition [Dey99]).
  bool can_merge(std::int32_t a, std::int32_t b) const {
    const auto shared = faces_on(a, b);
    const auto x = neighbours(a), y = neighbours(b);
    std::vector<std::int32_t> common;
    std::set_intersection(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(common));
    if (common.size() != shared.size()) return false;
    return shared.size() < 2 || !on_border(a) || !on_border(b);
  }

  void merge(std::int32_t a, std::int32_t b) {
    // A vertex of the border stays, so that the border keeps its place in the file.
    std::int32_t keep = std::min(a, b), gone = std::max(a, b);
    if (!on_border(keep) && on_border(gone)) std::swap(keep, gone);
    for (const std::int32_t f : faces_on(keep, gone)) drop(f);
    const std::vector<std::int32_t> moved = around_[gone];
    for (const std::int32_t f : moved) {
      detach(f);
      std::replace(mesh_.faces[f].begin(), mesh_.faces[f].end(), gone, keep);
      attach(f);
    }
  }

  /// The face beyond side (p, q) of the cap f gets its corner m there. \return whether that can be
  bool split_beyond(std::int32_t f, std::int32_t p, std::int32_t q, std::int32_t m) {
    std::vector<std::int32_t> beyond = faces_on(p, q);
    std::erase(beyond, f);
    if (beyond.size() != 1 || splits_left_ == 0) return false;
    const std::int32_t g = beyond[0];
    auto c = corners(g);
    // Side pq of g first.
    while (c[2] == p || c[2] == q) std::rotate(c.begin(), c.begin() + 1, c.end());
    const std::int32_t r = c[2];
    if (r == m || !faces_on(m, r).empty()) return false;
    --splits_left_;
    ++dropped_;
    detach(f);
    detach(g);
    mesh_.faces[g] = {c[0], m, r};
    mesh_.faces[f] = {m, c[1], r};
    attach(g);
    attach(f);
    mesh_.face_source[f] = mesh_.face_source[g];
    if (!mesh_.face_line.empty()) mesh_.face_line[f] = mesh_.face_line[g];
    if (!mesh_.virtual_face.empty()) mesh_.virtual_face[f] = mesh_.virtual_face[g];
    queue_.push_back(g);
    queue_.push_back(f);
    return true;
  }

  void resolve(std::int32_t f) {
    const auto c = corners(f);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return drop(f);
    int shortest = 0, longest = 0;
    double side[3];
    for (int k = 0; k < 3; ++k) {
      side[k] = length(c[k], c[(k + 1) % 3]);
      if (side[k] < side[shortest]) shortest = k;
      if (side[k] > side[longest]) longest = k;
    }
    if (side[shortest] <= kSamePlace * side[longest]) {
      const std::int32_t a = c[shortest], b = c[(shortest + 1) % 3];
      return can_merge(a, b) ? merge(a, b) : drop(f);
    }
    if (!split_beyond(f, c[longest], c[(longest + 1) % 3], c[(longest + 2) % 3])) drop(f);
  }

  Mesh& mesh_;
  std::vector<std::vector<std::int32_t>> around_;  // faces of each vertex
  std::vector<char> dead_;
  std::deque<std::int32_t> queue_;
  std::size_t splits_left_ = 0;
  Index dropped_ = 0;
};

}  // namespace

Index drop_degenerate_faces(Mesh& mesh) {
  bool any = false;
  for (Index f = 0; f < mesh.face_count() && !any; ++f) any = is_degenerate(mesh, f);
  if (!any) return 0;
  name_sources(mesh);
  return Dropper(mesh).run();
}

}  // namespace knotfit
