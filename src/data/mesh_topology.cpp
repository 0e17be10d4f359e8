#include "data/mesh_topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

constexpr Index kMost =
    std::numeric_limits<std::int32_t>::max() / 3 - 1;  // half-edges are counted in 32 bits

Index checked_face_count(const Mesh& mesh) {
  const Index n = mesh.vertex_count();
  if (mesh.vertices.size() % 3 != 0)
    throw InvalidInput(
        fmt::format("{} coordinates of vertices are not three a vertex", mesh.vertices.size()));
  if (mesh.faces.empty()) throw InvalidInput("the mesh has no faces");
  if (n > kMost || mesh.face_count() > kMost)
    throw InvalidInput(fmt::format("a mesh of {} vertices and {} faces is too large; at most {} of each", n,
                                   mesh.face_count(), kMost));
  for (Index k = 0; k < n; ++k)
    for (int d = 0; d < 3; ++d)
      if (!std::isfinite(mesh.vertex(k)[d]))
        throw InvalidInput(fmt::format("vertex {} of the mesh is not finite", k + mesh.counted_from));
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (const std::int32_t v : mesh.faces[f])
      if (v < 0 || v >= n)
        throw InvalidInput(fmt::format("face {} of the mesh names vertex {}, but there are {} vertices",
                                       f + mesh.counted_from, v + mesh.counted_from, n));
  return mesh.face_count();
}

}  // namespace

DisjointSets::DisjointSets(Index n) : parent_(static_cast<std::size_t>(n)) {
  std::iota(parent_.begin(), parent_.end(), 0);
}

std::int32_t DisjointSets::root(std::int32_t k) const {
  while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
  return k;
}

void DisjointSets::unite(std::int32_t a, std::int32_t b) {
  a = root(a);
  b = root(b);
  // The least is the root, so that results follow the order of the file.
  parent_[std::max(a, b)] = std::min(a, b);
}

MeshTopology::MeshTopology(const Mesh& mesh)
    : repeated(static_cast<std::size_t>(checked_face_count(mesh)), 0),
      mesh_(&mesh),
      parts_(mesh.face_count()),
      fans_(3 * mesh.face_count()) {
  struct Keyed {
    std::int32_t b, half_edge;
  };
  // Half-edges by their smaller vertex (counting sort), then by the larger one.
  std::vector<std::int32_t> start(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& c = mesh.faces[f];
    repeated[f] = c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
    if (repeated[f]) continue;
    for (int k = 0; k < 3; ++k) ++start[std::min(c[k], c[(k + 1) % 3]) + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Keyed> keyed(static_cast<std::size_t>(start.back()));
  std::vector<std::int32_t> next(start.begin(), start.end() - 1);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (repeated[f]) continue;
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = mesh.faces[f][k], b = mesh.faces[f][(k + 1) % 3];
      keyed[next[std::min(a, b)]++] = {std::max(a, b), static_cast<std::int32_t>(3 * f + k)};
    }
  }
  half_edges.reserve(keyed.size());
  edges.reserve(keyed.size() / 2 + 1);
  for (std::int32_t a = 0; a < mesh.vertex_count(); ++a) {
    std::sort(keyed.begin() + start[a], keyed.begin() + start[a + 1], [](const Keyed& x, const Keyed& y) {
      return x.b != y.b ? x.b < y.b : x.half_edge < y.half_edge;
    });
    for (std::int32_t i = start[a]; i < start[a + 1]; ++i) {
      if (i == start[a] || keyed[i].b != keyed[i - 1].b) edges.push_back({a, keyed[i].b, i, 0});
      ++edges.back().count;
      half_edges.push_back(keyed[i].half_edge);
    }
  }
  const auto corner_at = [this](std::int32_t half_edge, std::int32_t vertex) {
    return from(half_edge) == vertex ? half_edge : half_edge - half_edge % 3 + (half_edge + 1) % 3;
  };
  for (const MeshEdge& e : edges)
    for (Index i = e.first + 1; i < e.first + e.count; ++i) {
      const std::int32_t h = half_edges[e.first], other = half_edges[i];
      parts_.unite(h / 3, other / 3);
      for (const std::int32_t v : {e.a, e.b}) fans_.unite(corner_at(h, v), corner_at(other, v));
    }
}

std::vector<BoundaryLoop> MeshTopology::loops() const {
  // Two boundary edges follow each other where they end the same fan: right at pinched vertices too.
  std::vector<std::int32_t> border;
  for (const MeshEdge& e : edges)
    if (e.count == 1) border.push_back(half_edges[e.first]);
  std::sort(border.begin(), border.end());
  std::vector<std::pair<std::int32_t, std::int32_t>> ends;  // fan, edge of the border
  for (std::size_t i = 0; i < border.size(); ++i) {
    const std::int32_t f = border[i] / 3, k = border[i] % 3;
    ends.emplace_back(fan(f, k), static_cast<std::int32_t>(i));
    ends.emplace_back(fan(f, (k + 1) % 3), static_cast<std::int32_t>(i));
  }
  std::sort(ends.begin(), ends.end());
  DisjointSets sets(static_cast<Index>(border.size()));
  for (std::size_t i = 1; i < ends.size(); ++i)
    if (ends[i].first == ends[i - 1].first) sets.unite(ends[i].second, ends[i - 1].second);

  std::vector<BoundaryLoop> loops;
  std::vector<std::int32_t> loop_of(border.size(), -1);
  for (std::size_t i = 0; i < border.size(); ++i) {
    const std::int32_t root = sets.root(static_cast<std::int32_t>(i));
    if (loop_of[root] < 0) {
      loop_of[root] = static_cast<std::int32_t>(loops.size());
      loops.emplace_back();
    }
    BoundaryLoop& loop = loops[loop_of[root]];
    loop.half_edges.push_back(border[i]);
    const double *p = mesh_->vertex(from(border[i])), *q = mesh_->vertex(to(border[i]));
    loop.length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  std::stable_sort(loops.begin(), loops.end(), [this](const BoundaryLoop& x, const BoundaryLoop& y) {
    const std::int32_t part_x = part(x.half_edges[0] / 3), part_y = part(y.half_edges[0] / 3);
    if (part_x != part_y) return part_x < part_y;
    return x.length != y.length ? x.length > y.length : x.half_edges.size() > y.half_edges.size();
  });
  return loops;
}

Orientation find_orientation(const Mesh& mesh, const MeshTopology& topology) {
  const Index n = mesh.face_count();
  // Across each edge of two faces: the other face, and whether it must be turned against this one.
  std::vector<std::int32_t> across(static_cast<std::size_t>(3 * n), -1);
  std::vector<char> against(across.size(), 0);
  for (const MeshEdge& e : topology.edges) {
    if (e.count != 2) continue;
    const std::int32_t h = topology.half_edges[e.first], g = topology.half_edges[e.first + 1];
    across[h] = g / 3;
    across[g] = h / 3;
    against[h] = against[g] = topology.from(h) == topology.from(g);
  }
  Orientation out;
  out.turn.assign(static_cast<std::size_t>(n), 0);
  std::vector<char> seen(static_cast<std::size_t>(n), 0);
  std::vector<std::int32_t> queue;
  for (Index start = 0; start < n; ++start) {
    if (seen[start] || topology.repeated[start]) continue;
    queue.assign(1, static_cast<std::int32_t>(start));
    seen[start] = 1;
    Index turned = 0;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const Index f = queue[head];
      turned += out.turn[f];
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = across[h];
        if (g < 0) continue;
        const char wanted = static_cast<char>(out.turn[f] ^ against[h]);
        if (!seen[g]) {
          seen[g] = 1;
          out.turn[g] = wanted;
          queue.push_back(static_cast<std::int32_t>(g));
        } else if (out.turn[g] != wanted && out.conflict < 0) {
          out.conflict = std::max(f, g);
        }
      }
    }
    if (2 * turned > static_cast<Index>(queue.size()))
      for (const std::int32_t f : queue) out.turn[f] ^= 1;
  }
  return out;
}

namespace {

struct Sides {
  double cross = 0;    ///< twice the area
  double longest = 0;  ///< side
};

/// Area over the square of `longest`: neither large nor small meshes overflow.
Sides sides_of(const Mesh& mesh, Index face) {
  const auto& c = mesh.faces[face];
  const double *p = mesh.vertex(c[0]), *q = mesh.vertex(c[1]), *r = mesh.vertex(c[2]);
  std::array<double, 3> e{}, g{};
  double most = 0;
  for (int d = 0; d < 3; ++d) {
    e[d] = q[d] - p[d];
    g[d] = r[d] - p[d];
    most = std::max({most, std::abs(e[d]), std::abs(g[d]), std::abs(g[d] - e[d])});
  }
  if (!(most > 0) || !std::isfinite(most)) return {0, most};
  for (int d = 0; d < 3; ++d) {
    e[d] /= most;
    g[d] /= most;
  }
  const double longest = std::sqrt(std::max(
      {e[0] * e[0] + e[1] * e[1] + e[2] * e[2], g[0] * g[0] + g[1] * g[1] + g[2] * g[2],
       (g[0] - e[0]) * (g[0] - e[0]) + (g[1] - e[1]) * (g[1] - e[1]) + (g[2] - e[2]) * (g[2] - e[2])}));
  const double x = e[1] * g[2] - e[2] * g[1], y = e[2] * g[0] - e[0] * g[2], z = e[0] * g[1] - e[1] * g[0];
  return {std::sqrt(x * x + y * y + z * z) / (longest * longest), longest * most};
}

}  // namespace

bool is_degenerate(const Mesh& mesh, Index face) {
  const auto& c = mesh.faces[face];
  if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return true;
  return !(sides_of(mesh, face).cross > 8 * std::numeric_limits<double>::epsilon());
}

double face_area(const Mesh& mesh, Index face) {
  const Sides sides = sides_of(mesh, face);
  return 0.5 * sides.cross * sides.longest * sides.longest;
}

}  // namespace knotfit
