// Holes closed by fans of virtual faces.
#include <algorithm>
#include <array>
#include <cmath>

#include "data/mesh_edit.h"
#include "data/mesh_topology.h"
namespace knotfit {
namespace {

using Vec = std::array<double, 3>;

Vec unit_normal(const Mesh& mesh, Index face) {
  const auto& c = mesh.faces[face];
  const double *p = mesh.vertex(c[0]), *q = mesh.vertex(c[1]), *r = mesh.vertex(c[2]);
  const Vec e{q[0] - p[0], q[1] - p[1], q[2] - p[2]}, g{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
  const Vec n{e[1] * g[2] - e[2] * g[1], e[2] * g[0] - e[0] * g[2], e[0] * g[1] - e[1] * g[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  return length > 0 ? Vec{n[0] / length, n[1] / length, n[2] / length} : Vec{};
}

/// Mean over the loop's edges, weighted by their lengths; `at` gives `d` numbers of a vertex.
template <std::size_t kSize, class At>
std::array<double, kSize> middle(const Mesh& mesh, const MeshTopology& topology, const BoundaryLoop& loop,
                                 const At& at) {
  std::array<double, kSize> sum{};
  double weight = 0;
  for (const std::int32_t h : loop.half_edges) {
    const std::int32_t a = topology.from(h), b = topology.to(h);
    const double *p = mesh.vertex(a), *q = mesh.vertex(b);
    const double length =
        loop.length > 0 ? std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / loop.length : 1;
    for (std::size_t d = 0; d < kSize; ++d) sum[d] += length * 0.5 * (at(a)[d] + at(b)[d]);
    weight += length;
  }
  for (double& x : sum) x /= weight;
  return sum;
}

void set_last_vertex(Mesh& mesh, const Vec& at) {
  std::copy(at.begin(), at.end(), mesh.vertices.end() - 3);
}

/// Moves the new vertex out of the lines of the loop's edges: a slit has its middle on them.
void lift_off(Mesh& mesh, Index first_face, const Vec& centre, Vec normal, double height) {
  const auto flat = [&] {
    for (Index f = first_face; f < mesh.face_count(); ++f)
      if (is_degenerate(mesh, f)) return true;
    return false;
  };
  if (!flat()) return;
  const Vec directions[] = {normal, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Vec& d : directions) {
    set_last_vertex(mesh, {centre[0] + height * d[0], centre[1] + height * d[1], centre[2] + height * d[2]});
    if (!flat()) return;
  }
  set_last_vertex(mesh, centre);
}

void fill(Mesh& mesh, const MeshTopology& topology, const BoundaryLoop& loop) {
  const Vec centre = middle<3>(mesh, topology, loop, [&](std::int32_t v) { return mesh.vertex(v); });
  Vec normal{};
  for (const std::int32_t h : loop.half_edges) {
    const Vec n = unit_normal(mesh, h / 3);
    for (int d = 0; d < 3; ++d) normal[d] += n[d] / static_cast<double>(loop.half_edges.size());
  }
  if (!mesh.uv.empty()) {
    const auto uv = middle<2>(mesh, topology, loop, [&](std::int32_t v) { return mesh.uv.data() + 2 * v; });
    mesh.uv.insert(mesh.uv.end(), uv.begin(), uv.end());
  }
  const auto added = static_cast<std::int32_t>(mesh.vertex_count());
  mesh.vertices.insert(mesh.vertices.end(), centre.begin(), centre.end());
  mesh.vertex_source.push_back(-1);
  if (!mesh.vertex_line.empty()) mesh.vertex_line.push_back(0);
  const Index first = mesh.face_count();
  for (const std::int32_t h : loop.half_edges) {
    const std::int32_t a = topology.from(h), b = topology.to(h);
    mesh.faces.push_back({b, a, added});  // against the face beyond the edge: oriented as it is
    mesh.face_source.push_back(-1);
    mesh.virtual_face.push_back(1);
    if (!mesh.face_line.empty()) mesh.face_line.push_back(0);
  }
  lift_off(mesh, first, centre, normal, 0.1 * loop.length);
}

}  // namespace

Index fill_holes(Mesh& mesh) {
  const MeshTopology topology(mesh);
  const std::vector<BoundaryLoop> loops = topology.loops();
  Index filled = 0;
  for (std::size_t k = 1; k < loops.size(); ++k) {
    if (topology.part(loops[k].half_edges[0] / 3) != topology.part(loops[k - 1].half_edges[0] / 3)) continue;
    name_sources(mesh);
    if (mesh.virtual_face.empty()) mesh.virtual_face.assign(mesh.faces.size(), 0);
    fill(mesh, topology, loops[k]);
    ++filled;
  }
  return filled;
}

}  // namespace knotfit
