// Faces that a file has twice, as two-sided models do: with their corners in the opposite order the second time.
#include <algorithm>
#include <array>
#include <numeric>

#include "data/mesh_edit.h"
#include "data/mesh_topology.h"
#include "knotfit/weld_mesh.h"
namespace knotfit {
namespace {

using Corners = std::array<std::int32_t, 3>;

/// Of each vertex the first one with the very same coordinates.
std::vector<std::int32_t> places_of(const Mesh& mesh) {
  std::vector<std::int32_t> order(static_cast<std::size_t>(mesh.vertex_count())), place(order.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](std::int32_t k) {
    const double* p = mesh.vertex(k);
    return std::array{p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};  // -0 is 0
  };
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    const auto p = at(a), q = at(b);
    return p != q ? p < q : a < b;
  });
  for (std::size_t k = 0; k < order.size(); ++k)
    place[order[k]] = k > 0 && at(order[k]) == at(order[k - 1]) ? place[order[k - 1]] : order[k];
  return place;
}

using Ring = std::vector<std::int32_t>;

/// From the least corner on, the same way round.
Ring from_least(Ring ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

/// A face of the file: triangles `first` to `end`, and its corners from the least on, the way round that comes first.
struct Polygon {
  std::size_t first = 0, end = 0;
  Ring ring;
  bool reversed = false;  ///< the ring runs against the face
};

/// Triangles of one face of the file are a fan; where they are none, each counts for itself.
std::vector<Polygon> polygons_of(const std::vector<Corners>& faces, const std::vector<std::int32_t>& source) {
  std::vector<Polygon> out;
  for (std::size_t f = 0; f < faces.size();) {
    Polygon p{.first = f, .end = f + 1, .ring = {faces[f].begin(), faces[f].end()}, .reversed = false};
    while (p.end < faces.size() && !source.empty() && source[p.end] == source[f] &&
           faces[p.end][0] == p.ring[0] && faces[p.end][1] == p.ring.back())
      p.ring.push_back(faces[p.end++][2]);
    Ring back = from_least({p.ring.rbegin(), p.ring.rend()});
    p.ring = from_least(std::move(p.ring));
    if (back < p.ring) p.ring = std::move(back), p.reversed = true;
    f = p.end;
    out.push_back(std::move(p));
  }
  return out;
}

bool repeats_a_corner(Ring ring) {
  std::sort(ring.begin(), ring.end());
  return std::adjacent_find(ring.begin(), ring.end()) != ring.end();
}

void drop_vertices_of(Mesh& mesh, const std::vector<char>& had_face) {
  std::vector<char> keep = used_vertices(mesh);
  for (std::size_t v = 0; v < keep.size(); ++v)
    if (had_face[v] == 0) keep[v] = 1;  // no face ever used it: not lost here
  keep_vertices(mesh, keep);
}

}  // namespace

DoubledFaces drop_doubled_faces(Mesh& mesh) {
  DoubledFaces out;
  if (mesh.faces.empty()) return out;
  const MeshTopology sound(mesh);  // throws where corners or coordinates are not sound
  const std::vector<std::int32_t> place = places_of(mesh);
  Mesh at_places;
  at_places.vertices = mesh.vertices;
  for (const Corners& c : mesh.faces) at_places.faces.push_back({place[c[0]], place[c[1]], place[c[2]]});
  const std::vector<Polygon> polygons = polygons_of(at_places.faces, mesh.face_source);
  std::vector<std::size_t> order(polygons.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return polygons[a].ring != polygons[b].ring ? polygons[a].ring < polygons[b].ring : a < b;
  });
  std::vector<char> keep(mesh.faces.size(), 1), both_ways(mesh.faces.size(), 0), had_face(place.size(), 0);
  const auto mark = [](std::vector<char>& marks, const Polygon& p, char value) {
    std::fill(marks.begin() + static_cast<Index>(p.first), marks.begin() + static_cast<Index>(p.end), value);
  };
  for (std::size_t k = 1, first = 0; k < order.size(); ++k) {
    const Polygon &p = polygons[order[k]], &kept = polygons[order[first]];
    if (p.ring != kept.ring) first = k;
    // A face of no area is no second one.
    if (first == k || repeats_a_corner(p.ring)) continue;
    mark(keep, p, 0);
    if (p.reversed != kept.reversed) mark(both_ways, kept, 1), ++out.reversed;
    ++out.faces;
  }
  if (out.faces == 0) return out;
  for (const Corners& c : mesh.faces)
    for (const std::int32_t v : c) had_face[v] = 1;
  // Of a face that is there both ways the one that agrees with its neighbours is kept.
  keep_faces(at_places, keep);
  keep_faces(mesh, keep);
  std::size_t left = 0;
  for (std::size_t f = 0; f < keep.size(); ++f)
    if (keep[f] != 0) both_ways[left++] = both_ways[f];
  const Orientation orientation = find_orientation(at_places, MeshTopology(at_places));
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (orientation.conflict < 0 && orientation.turn[f] != 0 && both_ways[f] != 0)
      std::swap(mesh.faces[f][1], mesh.faces[f][2]);
  drop_vertices_of(mesh, had_face);
  return out;
}

}  // namespace knotfit
