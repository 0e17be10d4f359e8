#include "parameterize/mesh_disk.h"

#include <algorithm>
#include <cmath>
#include <limits>
namespace knotfit::mesh_map {
namespace {

struct Side {
  std::int32_t low, high;  // ends
  int face, corner;        // opposite corner
  bool operator<(const Side& other) const {
    return low != other.low ? low < other.low : high != other.high ? high < other.high : face < other.face;
  }
  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

// Edges in the order of their ends, the faces at each edge together.
std::vector<Side> sorted_sides(const std::vector<Face>& faces) {
  std::vector<Side> sides;
  sides.reserve(3 * faces.size());
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = faces[f][(k + 1) % 3], b = faces[f][(k + 2) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), f, k});
    }
  std::sort(sides.begin(), sides.end());
  return sides;
}

void scale_to_unit_diagonal(const Mesh& mesh, DiskMesh& disk) {
  Position low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (Index i = 0; i < mesh.vertex_count(); ++i)
    for (int c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], mesh.vertex(i)[c]);
      high[c] = std::max(high[c], mesh.vertex(i)[c]);
    }
  const double diagonal = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  disk.position.resize(static_cast<std::size_t>(mesh.vertex_count()));
  for (Index i = 0; i < mesh.vertex_count(); ++i)
    for (int c = 0; c < 3; ++c) disk.position[i][c] = (mesh.vertex(i)[c] - low[c]) / diagonal;
}

void mark_boundary(DiskMesh& disk, const std::vector<Side>& sides) {
  disk.on_boundary.assign(disk.position.size(), 0);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const bool shared = (k > 0 && sides[k].same_edge(sides[k - 1])) ||
                        (k + 1 < sides.size() && sides[k].same_edge(sides[k + 1]));
    if (!shared) disk.on_boundary[sides[k].low] = disk.on_boundary[sides[k].high] = 1;
  }
}

// Halves the inner edges with both ends on the boundary, at most one a face and pass.
bool halve_chords(DiskMesh& disk) {
  const std::vector<Side> sides = sorted_sides(disk.face);
  std::vector<char> used(disk.face.size(), 0);
  bool found = false;
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const Side &first = sides[k], &second = sides[k + 1];
    if (!first.same_edge(second) || !disk.on_boundary[first.low] || !disk.on_boundary[first.high]) continue;
    found = true;
    if (used[first.face] || used[second.face]) continue;
    used[first.face] = used[second.face] = 1;
    const auto middle = static_cast<std::int32_t>(disk.position.size());
    const Position &a = disk.position[first.low], &b = disk.position[first.high];
    disk.position.push_back({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
    disk.on_boundary.push_back(0);
    disk.halved.push_back({first.low, first.high});
    for (const Side* side : {&first, &second}) {
      Face beside_low = disk.face[side->face], beside_high = beside_low;
      for (int q = 0; q < 3; ++q) {
        if (beside_low[q] == first.high) beside_low[q] = middle;
        if (beside_high[q] == first.low) beside_high[q] = middle;
      }
      disk.face[side->face] = beside_low;
      disk.face.push_back(beside_high);
      disk.virtual_face.push_back(disk.virtual_face[side->face]);
    }
  }
  return found;
}

void number_edges(DiskMesh& disk) {
  const std::vector<Side> sides = sorted_sides(disk.face);
  disk.face_edge.resize(disk.face.size());
  std::vector<int> next(disk.position.size(), -1), next_edge(disk.position.size(), -1);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (k == 0 || !sides[k].same_edge(sides[k - 1])) disk.edge.push_back({sides[k].low, sides[k].high});
    const int e = static_cast<int>(disk.edge.size()) - 1;
    disk.face_edge[sides[k].face][sides[k].corner] = e;
    const bool shared = (k > 0 && sides[k].same_edge(sides[k - 1])) ||
                        (k + 1 < sides.size() && sides[k].same_edge(sides[k + 1]));
    if (shared) continue;
    const int from = disk.face[sides[k].face][(sides[k].corner + 1) % 3];
    next[from] = disk.face[sides[k].face][(sides[k].corner + 2) % 3];
    next_edge[from] = e;
  }
  const int start =
      static_cast<int>(std::find_if(next.begin(), next.end(), [](int i) { return i >= 0; }) - next.begin());
  for (int i = start; disk.loop.empty() || i != start; i = next[i]) {
    disk.loop.push_back(i);
    disk.loop_edge.push_back(next_edge[i]);
  }
}

void find_normals(DiskMesh& disk) {
  disk.normal.assign(disk.position.size(), Position{0, 0, 0});
  for (const Face& t : disk.face)
    for (int k = 0; k < 3; ++k) {
      const Position &p = disk.position[t[k]], &q = disk.position[t[(k + 1) % 3]],
                     &r = disk.position[t[(k + 2) % 3]];
      const Position a{q[0] - p[0], q[1] - p[1], q[2] - p[2]}, b{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
      const Position n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
      const double sine = std::hypot(n[0], n[1], n[2]), cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      if (!(sine > 0)) continue;
      const double angle = std::atan2(sine, cosine);
      for (int c = 0; c < 3; ++c) disk.normal[t[k]][c] += angle / sine * n[c];
    }
  for (Position& n : disk.normal) {
    const double length = std::hypot(n[0], n[1], n[2]);
    if (length > 0)
      for (double& c : n) c /= length;
  }
}

}  // namespace

DiskMesh faces_alone(const Mesh& mesh) {
  DiskMesh disk;
  disk.own = mesh.vertex_count();
  scale_to_unit_diagonal(mesh, disk);
  disk.face = disk.own_face = mesh.faces;
  disk.virtual_face = mesh.virtual_face;
  disk.virtual_face.resize(disk.face.size(), 0);
  disk.normal.assign(disk.position.size(), Position{0, 0, 0});
  return disk;
}

DiskMesh make_disk(const Mesh& mesh) {
  DiskMesh disk = faces_alone(mesh);
  mark_boundary(disk, sorted_sides(disk.face));
  while (halve_chords(disk)) {
  }
  number_edges(disk);
  find_normals(disk);
  return disk;
}

}  // namespace knotfit::mesh_map
