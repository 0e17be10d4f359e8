// Triangle meshes: what they hold, whether they are a disk, and what can be done where they are not.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "knotfit/index.h"
namespace [[gnu::visibility("default")]] knotfit {

/// Polygons come as fans of triangles; virtual triangles close holes and are never data.
struct Mesh {
  std::vector<double> vertices;  ///< n x 3, row-major
  std::vector<std::array<std::int32_t, 3>>
      faces;                                  ///< corners, counted from 0, counter-clockwise from outside
  std::vector<double> uv;                     ///< n x 2 where the file gave parameters; else empty
  std::vector<Index> vertex_line, face_line;  ///< line in the file, from 1; empty: binary, index
  std::vector<std::int32_t> face_source;      ///< face of the file each triangle came from; empty: itself
  std::vector<Index> vertex_source;           ///< likewise of vertices, after a repair; -1: added
  Index counted_from = 0;                     ///< number of the file's first face and vertex: 1 for OBJ
  std::vector<char> virtual_face;             ///< 1: closes a hole; empty: none
  Index vertex_count() const { return static_cast<Index>(vertices.size()) / 3; }
  Index face_count() const { return static_cast<Index>(faces.size()); }
  const double* vertex(Index k) const { return vertices.data() + 3 * k; }
};

/// What keeps a mesh from being a disk: the first of each kind found.
struct MeshReport {
  Index parts = 0;                       ///< connected by edges
  std::vector<Index> part_faces;         ///< faces of each, largest first
  std::vector<Index> loop_edges;         ///< edges of each boundary loop, the longest in space first
  Index nonmanifold_edge[2] = {-1, -1};  ///< vertices of an edge with more than two faces
  Index nonmanifold_vertex = -1;         ///< a vertex whose faces do not form one fan
  Index misoriented_face = -1;           ///< a face turned against most of its part
  Index degenerate_face = -1;            ///< a face of no area or with a repeated corner
  Index unused_vertices = 0;
  bool orientable = true;
  int euler_characteristic = 0;
  bool disk() const {
    return parts == 1 && loop_edges.size() == 1 && nonmanifold_edge[0] < 0 && nonmanifold_vertex < 0 &&
           misoriented_face < 0 && degenerate_face < 0 && euler_characteristic == 1;
  }
};
/// O(n log n). Faces with a repeated corner count as not there, but for `degenerate_face`.
/// \throws InvalidInput  no faces, a corner that is no vertex, coordinates that are not finite
MeshReport inspect(const Mesh& mesh);

struct MeshRepair {
  bool largest_part = false;  ///< keep the part with the most area
  bool fill_holes = false;    ///< close every boundary loop but the longest by a fan of virtual faces
  bool orient = false;        ///< turn faces so that neighbours agree
  bool drop_degenerate =
      false;  ///< drop faces of no area, merging vertices at the same place where that closes the gap
};
struct RepairSummary {
  Index dropped_parts = 0, dropped_faces = 0, filled_holes = 0, turned_faces = 0, dropped_vertices = 0;
};
/// Vertex k of the result came from vertex `kept[k]` of the mesh (-1: added).
struct RepairedMesh {
  Mesh mesh;
  std::vector<Index> kept;
  RepairSummary summary;
};
/// Does what is asked, and removes vertices no face uses. \throws InvalidInput  nothing is left, not orientable
RepairedMesh repair(const Mesh& mesh, const MeshRepair& options);

/// \throws InvalidInput  where the mesh is not a disk: which kind, where (face, vertex, line), what to do
///   (what repair() offers, or cutting it open)
void require_disk(const Mesh& mesh);

}  // namespace knotfit
