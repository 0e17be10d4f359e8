// What keeps a mesh from being a disk, and how to say so.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "data/mesh_topology.h"
#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
namespace knotfit {
namespace {

/// Vertices whose faces form more than one fan: the first of them; and how many vertices faces use.
struct VertexFans {
  Index pinched = -1, used = 0;
};

VertexFans count_fans(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<std::int32_t> fan(static_cast<std::size_t>(mesh.vertex_count()), -1);
  std::vector<char> several(fan.size(), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (topology.repeated[f]) continue;
    for (int k = 0; k < 3; ++k) {
      const std::int32_t v = mesh.faces[f][k], root = topology.fan(f, k);
      if (fan[v] < 0) fan[v] = root;
      several[v] |= fan[v] != root;
    }
  }
  VertexFans out;
  const auto first = std::find(several.begin(), several.end(), 1);
  if (first != several.end()) out.pinched = first - several.begin();
  out.used = static_cast<Index>(fan.size()) - std::count(fan.begin(), fan.end(), -1);
  return out;
}

MeshReport report_of(const Mesh& mesh, const MeshTopology& topology) {
  MeshReport report;
  const Index n = mesh.face_count();
  std::vector<Index> faces_of(static_cast<std::size_t>(n), 0);
  Index faces = 0;
  for (Index f = 0; f < n; ++f) {
    if (report.degenerate_face < 0 && is_degenerate(mesh, f)) report.degenerate_face = f;
    if (topology.repeated[f]) continue;
    ++faces;
    ++faces_of[topology.part(f)];
  }
  for (const Index count : faces_of)
    if (count > 0) report.part_faces.push_back(count);
  std::sort(report.part_faces.rbegin(), report.part_faces.rend());
  report.parts = static_cast<Index>(report.part_faces.size());

  for (const MeshEdge& e : topology.edges)
    if (e.count > 2) {
      report.nonmanifold_edge[0] = e.a;
      report.nonmanifold_edge[1] = e.b;
      break;
    }
  std::vector<BoundaryLoop> loops = topology.loops();
  std::stable_sort(loops.begin(), loops.end(),
                   [](const BoundaryLoop& x, const BoundaryLoop& y) { return x.length > y.length; });
  for (const BoundaryLoop& loop : loops)
    report.loop_edges.push_back(static_cast<Index>(loop.half_edges.size()));

  const VertexFans fans = count_fans(mesh, topology);
  report.nonmanifold_vertex = fans.pinched;
  report.unused_vertices = mesh.vertex_count() - fans.used;
  const Orientation orientation = find_orientation(mesh, topology);
  report.orientable = orientation.conflict < 0;
  const auto turned = std::find(orientation.turn.begin(), orientation.turn.end(), 1);
  if (!report.orientable)
    report.misoriented_face = orientation.conflict;
  else if (turned != orientation.turn.end())
    report.misoriented_face = turned - orientation.turn.begin();
  report.euler_characteristic =
      static_cast<int>(fans.used - static_cast<Index>(topology.edges.size()) + faces);
  return report;
}

/// Faces and vertices as their file names them.
class Names {
 public:
  explicit Names(const Mesh& mesh) : mesh_(mesh) {}
  std::string face(Index f) const {
    const Index source = mesh_.face_source.empty() ? f : mesh_.face_source[f];
    if (source < 0) return "a face that closes a hole";
    return fmt::format("face {} ({})", source + mesh_.counted_from, where(mesh_.face_line, f));
  }
  std::string number(Index v) const {
    const Index source = mesh_.vertex_source.empty() ? v : mesh_.vertex_source[v];
    return source < 0 ? "(added)" : fmt::format("{}", source + mesh_.counted_from);
  }
  std::string vertex(Index v) const {
    return fmt::format("vertex {} ({})", number(v), where(mesh_.vertex_line, v));
  }

 private:
  std::string where(const std::vector<Index>& lines, Index k) const {
    const std::string counted = fmt::format("counted from {}", mesh_.counted_from);
    return lines.empty() || lines[k] < 1 ? counted : fmt::format("{}, line {}", counted, lines[k]);
  }
  const Mesh& mesh_;
};

std::string nonmanifold_edge_text(const Mesh& mesh, const MeshReport& report, const MeshTopology& topology) {
  const Names names(mesh);
  const auto e = std::find_if(topology.edges.begin(), topology.edges.end(),
                              [](const MeshEdge& edge) { return edge.count > 2; });
  return fmt::format(
      "the edge between vertices {} and {} has {} faces, more than two (non-manifold edge); the third is "
      "{}. "
      "Delete faces there until two are left, or cut the mesh open along the edge",
      names.number(report.nonmanifold_edge[0]), names.number(report.nonmanifold_edge[1]), e->count,
      names.face(topology.half_edges[e->first + 2] / 3));
}

std::string degenerate_text(const Mesh& mesh, const MeshReport& report) {
  const Names names(mesh);
  const auto& c = mesh.faces[report.degenerate_face];
  Index count = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) count += is_degenerate(mesh, f);
  std::string why = "its corners lie on a line";
  for (int k = 0; k < 3; ++k) {
    const std::int32_t a = c[k], b = c[(k + 1) % 3];
    if (a == b) {
      why = fmt::format("vertex {} is its corner twice", names.number(a));
      break;
    }
    if (std::equal(mesh.vertex(a), mesh.vertex(a) + 3, mesh.vertex(b)))
      why = fmt::format("its vertices {} and {} are at the same place", names.number(std::min(a, b)),
                        names.number(std::max(a, b)));
  }
  return fmt::format("{} has no area: {} ({} such face{}, degenerate); {} removes {}",
                     names.face(report.degenerate_face), why, count, count == 1 ? "" : "s",
                     remedy_text(Remedy::drop_degenerate), count == 1 ? "it" : "them");
}

std::string orientation_text(const Mesh& mesh, const MeshReport& report) {
  const Names names(mesh);
  const std::string face = names.face(report.misoriented_face);
  if (!report.orientable)
    return fmt::format(
        "the mesh has one side only, like a Moebius band: no orientation of its faces agrees "
        "(at {}); cut it open",
        face);
  return fmt::format(
      "{} has its corners in the opposite order to its neighbours: misoriented; {} turns such faces", face,
      remedy_text(Remedy::orient));
}

std::string parts_text(const Mesh& mesh, const MeshReport& report, const MeshTopology& topology) {
  const Names names(mesh);
  Index second = 0;
  while (second < mesh.face_count() &&
         (topology.repeated[second] || topology.part(second) == topology.part(0)))
    ++second;
  std::string faces;
  for (std::size_t k = 0; k < report.part_faces.size() && k < 5; ++k)
    faces += fmt::format("{}{}", k == 0 ? "" : ", ", report.part_faces[k]);
  if (report.part_faces.size() > 5) faces += ", ...";
  return fmt::format(
      "the mesh has {} parts that are not joined, of {} faces; the second begins at {}. "
      "{} keeps the one with the most area",
      report.parts, faces, names.face(second), remedy_text(Remedy::largest_part));
}

/// The middle of a loop by the lengths of its edges, and the area it encloses, as a vector.
struct LoopShape {
  std::array<double, 3> middle{}, area{};
};

LoopShape shape_of(const Mesh& mesh, const MeshTopology& topology, const BoundaryLoop& loop) {
  LoopShape shape;
  const double* origin = mesh.vertex(topology.from(loop.half_edges[0]));
  for (const std::int32_t h : loop.half_edges) {
    const double *p = mesh.vertex(topology.from(h)), *q = mesh.vertex(topology.to(h));
    const double length = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3, e = (c + 2) % 3;
      if (loop.length > 0) shape.middle[c] += length / loop.length * 0.5 * (p[c] + q[c]);
      shape.area[c] +=
          0.5 * ((p[d] - origin[d]) * (q[e] - origin[e]) - (p[e] - origin[e]) * (q[d] - origin[d]));
    }
  }
  return shape;
}

/// Two loops of about one length that lie one above the other: the ends of a tube.
bool ends_of_a_tube(const Mesh& mesh, const MeshTopology& topology, const std::vector<BoundaryLoop>& loops) {
  if (loops.size() != 2 || !(loops[1].length > 0.5 * loops[0].length)) return false;
  const LoopShape a = shape_of(mesh, topology, loops[0]), b = shape_of(mesh, topology, loops[1]);
  double along = 0, area = 0;
  for (int c = 0; c < 3; ++c) along += a.area[c] * (b.middle[c] - a.middle[c]), area += a.area[c] * a.area[c];
  const double radius = loops[0].length / (2 * std::numbers::pi);
  return std::abs(along) > 0.5 * radius * std::sqrt(area);
}

std::string loops_text(const Mesh& mesh, const MeshReport& report, const MeshTopology& topology) {
  const Names names(mesh);
  if (report.loop_edges.empty())
    return "the mesh is closed: it has no boundary loop at all, and a surface patch needs one; cut it open";
  std::string edges;
  for (std::size_t k = 0; k < report.loop_edges.size() && k < 5; ++k)
    edges += fmt::format("{}{}", k == 0 ? "" : ", ", report.loop_edges[k]);
  if (report.loop_edges.size() > 5) edges += ", ...";
  const std::vector<BoundaryLoop> loops = topology.loops();
  std::string openings;
  for (std::size_t k = 1; k < loops.size() && k < 6; ++k) {
    const LoopShape shape = shape_of(mesh, topology, loops[k]);
    openings += fmt::format(", at ({:.8g}, {:.8g}, {:.8g}) {:.3g} around", shape.middle[0], shape.middle[1],
                            shape.middle[2], loops[k].length);
  }
  if (loops.size() > 6) openings += ", ...";
  std::string text = fmt::format(
      "the mesh has {} boundary loops, of {} edges: {} opening{} beside its rim{}; the second passes {}. "
      "{} closes all but the longest, and the surface is free there",
      loops.size(), edges, loops.size() - 1, loops.size() == 2 ? "" : "s", openings,
      names.vertex(topology.from(loops[1].half_edges[0])), remedy_text(Remedy::fill_holes));
  if (ends_of_a_tube(mesh, topology, loops))
    text += fmt::format(
        "; a tube is better fitted around an axis: make points of the mesh ({}) and fit these with {}",
        remedy_text(Remedy::vertices), remedy_text(Remedy::base, "cylinder"));
  return text;
}

}  // namespace

MeshReport inspect(const Mesh& mesh) {
  return report_of(mesh, MeshTopology(mesh));
}

void require_disk(const Mesh& mesh) {
  const MeshTopology topology(mesh);
  const MeshReport report = report_of(mesh, topology);
  if (report.disk()) return;
  const Names names(mesh);
  // What spoils the counts of others comes first.
  if (report.degenerate_face >= 0) throw InvalidInput(degenerate_text(mesh, report));
  if (report.nonmanifold_edge[0] >= 0) throw InvalidInput(nonmanifold_edge_text(mesh, report, topology));
  if (report.misoriented_face >= 0) throw InvalidInput(orientation_text(mesh, report));
  if (report.nonmanifold_vertex >= 0)
    throw InvalidInput(fmt::format(
        "{} joins faces that share no edge there: a non-manifold vertex; {}",
        names.vertex(report.nonmanifold_vertex),
        report.parts > 1 ? remedy_text(Remedy::largest_part) +
                               " keeps the part with the most area, or give each part a vertex of its own"
                         : "give each fan of faces a vertex of its own, cutting the mesh open there"));
  if (report.parts > 1) throw InvalidInput(parts_text(mesh, report, topology));
  if (report.loop_edges.size() != 1) throw InvalidInput(loops_text(mesh, report, topology));
  const int handles = (1 - report.euler_characteristic) / 2;
  throw InvalidInput(fmt::format(
      "the mesh has {} handle{} (Euler characteristic {}), so it is no disk; cut it open "
      "along {}",
      handles, handles == 1 ? "" : "s", report.euler_characteristic, handles == 1 ? "it" : "each"));
}

}  // namespace knotfit
