#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "data/mesh_edit.h"
#include "data/mesh_topology.h"
#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
namespace knotfit {
namespace {

/// The entries of `values`, `width` each, whose `keep` is not 0; an empty one stays so.
template <class T>
void filter(std::vector<T>& values, const std::vector<char>& keep, std::size_t width = 1) {
  if (values.empty()) return;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < keep.size(); ++k)
    if (keep[k]) {
      std::copy_n(values.begin() + static_cast<Index>(k * width), width,
                  values.begin() + static_cast<Index>(kept * width));
      ++kept;
    }
  values.resize(kept * width);
}

void check_sizes(const Mesh& mesh) {
  const std::size_t n = mesh.vertices.size() / 3, faces = mesh.faces.size();
  const auto fits = [](std::size_t size, std::size_t wanted) { return size == 0 || size == wanted; };
  if (!fits(mesh.uv.size(), 2 * n) || !fits(mesh.vertex_line.size(), n) ||
      !fits(mesh.vertex_source.size(), n) || !fits(mesh.face_line.size(), faces) ||
      !fits(mesh.face_source.size(), faces) || !fits(mesh.virtual_face.size(), faces))
    throw InvalidInput(
        fmt::format("a mesh of {} vertices and {} faces has parameters, lines, sources or marks of "
                    "another number",
                    n, faces));
}

/// \return faces dropped
Index keep_largest_part(Mesh& mesh, Index& dropped_parts) {
  const MeshTopology topology(mesh);
  std::vector<double> area(mesh.faces.size(), -1);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (topology.repeated[f]) continue;
    double& sum = area[topology.part(f)];
    sum = std::max(sum, 0.0) + face_area(mesh, f);
  }
  const auto largest = static_cast<std::int32_t>(std::max_element(area.begin(), area.end()) - area.begin());
  const Index parts = std::count_if(area.begin(), area.end(), [](double a) { return a >= 0; });
  if (parts <= 1) return 0;
  dropped_parts += parts - 1;
  std::vector<char> keep(mesh.faces.size());
  for (Index f = 0; f < mesh.face_count(); ++f)
    keep[f] = !topology.repeated[f] && topology.part(f) == largest;
  const Index before = mesh.face_count();
  keep_faces(mesh, keep);
  return before - mesh.face_count();
}

/// \return faces turned
Index orient(Mesh& mesh) {
  const Orientation orientation = find_orientation(mesh, MeshTopology(mesh));
  if (orientation.conflict >= 0) {
    const Index f = orientation.conflict;
    throw InvalidInput(fmt::format(
        "the mesh has one side only, like a Moebius band: {} finds no orientation that its faces agree on "
        "(at face {}, counted from {}); cut it open",
        remedy_text(Remedy::orient), (mesh.face_source.empty() ? f : mesh.face_source[f]) + mesh.counted_from,
        mesh.counted_from));
  }
  Index turned = 0;
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (orientation.turn[f]) {
      std::swap(mesh.faces[f][1], mesh.faces[f][2]);
      ++turned;
    }
  return turned;
}

/// \return kept[k]: the vertex that vertex k was
std::vector<Index> drop_unused_vertices(Mesh& mesh) {
  const std::vector<char> used = used_vertices(mesh);
  std::vector<Index> kept;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) kept.push_back(static_cast<Index>(v));
  if (kept.size() < used.size()) keep_vertices(mesh, used);
  return kept;
}

}  // namespace

void name_sources(Mesh& mesh) {
  const auto fill = [](auto& source, std::size_t n) {
    if (!source.empty()) return;
    source.resize(n);
    std::iota(source.begin(), source.end(), 0);
  };
  fill(mesh.face_source, mesh.faces.size());
  fill(mesh.vertex_source, static_cast<std::size_t>(mesh.vertex_count()));
}

void keep_faces(Mesh& mesh, const std::vector<char>& keep) {
  name_sources(mesh);
  filter(mesh.faces, keep);
  filter(mesh.face_line, keep);
  filter(mesh.face_source, keep);
  filter(mesh.virtual_face, keep);
}

std::vector<char> used_vertices(const Mesh& mesh) {
  std::vector<char> used(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (const auto& c : mesh.faces)
    for (const std::int32_t v : c) used[v] = 1;
  return used;
}

void keep_vertices(Mesh& mesh, const std::vector<char>& keep) {
  name_sources(mesh);
  std::vector<std::int32_t> number(keep.size(), -1);
  std::int32_t next = 0;
  for (std::size_t v = 0; v < keep.size(); ++v)
    if (keep[v]) number[v] = next++;
  for (auto& c : mesh.faces)
    for (std::int32_t& v : c) v = number[v];
  filter(mesh.vertices, keep, 3);
  filter(mesh.uv, keep, 2);
  filter(mesh.vertex_line, keep);
  filter(mesh.vertex_source, keep);
}

RepairedMesh repair(const Mesh& mesh, const MeshRepair& options) {
  const MeshTopology sound(mesh);  // throws where corners or coordinates are not sound
  check_sizes(mesh);
  RepairedMesh out{.mesh = mesh, .kept = {}, .summary = {}};
  const auto require_faces = [&] {
    if (out.mesh.faces.empty()) throw InvalidInput("nothing is left of the mesh: every face has no area");
  };
  if (options.drop_degenerate) out.summary.dropped_faces += drop_degenerate_faces(out.mesh);
  require_faces();
  if (options.largest_part)
    out.summary.dropped_faces += keep_largest_part(out.mesh, out.summary.dropped_parts);
  require_faces();
  if (options.orient) out.summary.turned_faces = orient(out.mesh);
  if (options.fill_holes) out.summary.filled_holes = fill_holes(out.mesh);
  out.kept = drop_unused_vertices(out.mesh);
  const Index before = mesh.vertex_count();
  Index added = 0;
  for (Index& k : out.kept)
    if (k >= before) {
      k = -1;
      ++added;
    }
  out.summary.dropped_vertices = before - (static_cast<Index>(out.kept.size()) - added);
  return out;
}

}  // namespace knotfit
