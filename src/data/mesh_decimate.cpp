#include "data/mesh_decimate.h"

#include <algorithm>
#include <cstdint>

#include "base/vec3.h"
#include "data/mesh_edit.h"
namespace knotfit {
namespace {

constexpr double kLeastCosine = 0.2;  // between a triangle's normals before and after
// Quality that triangles keep, 1: equilateral. Each bound is left for the next where it takes out fewer than kLeastGain of
// the vertices that are still to go.
constexpr double kLeastQuality[] = {0.3, 0.15, 0.08};
constexpr double kLeastGain = 0.05;

class Decimation {
 public:
  Decimation(const Mesh& mesh, const std::vector<char>& keep)
      : mesh_(mesh),
        faces_(mesh.faces),
        alive_(mesh.faces.size(), 1),
        star_(static_cast<std::size_t>(mesh.vertex_count())),
        stays_(keep),
        touched_(keep.size(), 0) {
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (const std::int32_t v : faces_[f]) {
        star_[v].push_back(static_cast<std::int32_t>(f));
        if (!mesh.virtual_face.empty() && mesh.virtual_face[f] != 0) stays_[v] = 1;
      }
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      if (on_border(v)) stays_[v] = 1;
  }

  void run() {
    std::vector<Index> left;
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (stays_[v] == 0) left.push_back(v);
    for (const double least : kLeastQuality)
      while (!left.empty()) {
        const std::size_t before = left.size();
        std::fill(touched_.begin(), touched_.end(), 0);
        std::erase_if(left, [&](Index v) { return touched_[v] == 0 && take_out(v, least); });
        if (static_cast<double>(before - left.size()) < kLeastGain * static_cast<double>(before)) break;
      }
  }

  Mesh result() && {
    Mesh out = mesh_;
    out.uv.clear();
    out.faces = std::move(faces_);
    keep_faces(out, alive_);
    keep_vertices(out, used_vertices(out));
    return out;
  }

 private:
  struct Neighbour {
    std::int32_t vertex;
    int faces;  ///< that both have
  };

  /// The vertices of the faces around v.
  std::vector<Neighbour> neighbours(Index v) const {
    std::vector<Neighbour> around;
    for (const std::int32_t f : star_[v])
      for (const std::int32_t w : faces_[f]) {
        if (w == v) continue;
        const auto known =
            std::find_if(around.begin(), around.end(), [&](const Neighbour& n) { return n.vertex == w; });
        if (known == around.end())
          around.push_back({w, 1});
        else
          ++known->faces;
      }
    return around;
  }

  bool on_border(Index v) const {
    const std::vector<Neighbour> around = neighbours(v);
    return std::any_of(around.begin(), around.end(), [](const Neighbour& n) { return n.faces != 2; });
  }

  Vec3 at(std::int32_t v) const {
    const double* p = mesh_.vertex(v);
    return {p[0], p[1], p[2]};
  }

  /// The least quality of the triangles that are left where v goes to w; below 0: it must not.
  double quality_after(Index v, std::int32_t w) const {
    double least = 1;
    for (const std::int32_t f : star_[v]) {
      const auto& t = faces_[f];
      if (std::find(t.begin(), t.end(), w) != t.end()) continue;
      Vec3 before[3], after[3];
      for (int k = 0; k < 3; ++k) {
        before[k] = at(t[k]);
        after[k] = t[k] == v ? at(w) : before[k];
      }
      const Vec3 old_normal = cross(before[1] - before[0], before[2] - before[0]);
      const Vec3 normal = cross(after[1] - after[0], after[2] - after[0]);
      if (!(dot(normal, old_normal) > kLeastCosine * length(normal) * length(old_normal))) return -1;
      double longest = 0;
      for (int k = 0; k < 3; ++k) longest = std::max(longest, squared(after[(k + 1) % 3] - after[k]));
      constexpr double equilateral = 1.1547005383792515;  // longest^2 over twice the area
      least = std::min(least, equilateral * length(normal) / longest);
    }
    return least;
  }

  /// Whether the vertices that both v and w see are those of the two faces that they share: else two sheets would join.
  bool keeps_topology(const std::vector<Neighbour>& around_v, std::int32_t w) const {
    const std::vector<Neighbour> around_w = neighbours(w);
    int common = 0;
    for (const Neighbour& a : around_v)
      common += std::any_of(around_w.begin(), around_w.end(),
                            [&](const Neighbour& b) { return a.vertex == b.vertex; });
    return common == 2;
  }

  bool take_out(Index v, double least_quality) {
    const std::vector<Neighbour> around = neighbours(v);
    double best = least_quality;
    std::int32_t to = -1;
    for (const Neighbour& n : around) {
      const double quality = quality_after(v, n.vertex);
      if (quality > best && keeps_topology(around, n.vertex)) best = quality, to = n.vertex;
    }
    if (to < 0) return false;
    for (const std::int32_t f : star_[v]) {
      auto& t = faces_[f];
      if (std::find(t.begin(), t.end(), to) != t.end()) {
        alive_[f] = 0;
        for (const std::int32_t w : t)
          if (w != v) std::erase(star_[w], f);
      } else {
        std::replace(t.begin(), t.end(), static_cast<std::int32_t>(v), to);
        star_[to].push_back(f);
      }
    }
    star_[v] = {};
    for (const Neighbour& n : around) touched_[n.vertex] = 1;
    return true;
  }

  const Mesh& mesh_;
  std::vector<std::array<std::int32_t, 3>> faces_;
  std::vector<char> alive_;
  std::vector<std::vector<std::int32_t>> star_;  ///< the faces of each vertex
  std::vector<char> stays_, touched_;            ///< touched: a neighbour went in this pass
};

}  // namespace

Mesh decimate(const Mesh& mesh, const std::vector<char>& keep) {
  Decimation decimation(mesh, keep);
  decimation.run();
  return std::move(decimation).result();
}

}  // namespace knotfit
