// Who neighbours whom in a triangle mesh, whatever is wrong with it.
#pragma once
#include <cstdint>
#include <vector>

#include "knotfit/mesh.h"
namespace knotfit {

/// Sets that merge; the root of a set is its least member.
class DisjointSets {
 public:
  explicit DisjointSets(Index n);
  std::int32_t root(std::int32_t k) const;
  void unite(std::int32_t a, std::int32_t b);

 private:
  mutable std::vector<std::int32_t> parent_;
};

/// An edge and the half-edges on it. Half-edge 3 f + k runs from corner k of face f to the next.
struct MeshEdge {
  std::int32_t a = 0, b = 0;  ///< vertices, a < b
  Index first = 0;            ///< into MeshTopology::half_edges
  std::int32_t count = 0;
};

/// A boundary loop: half-edges in no order.
struct BoundaryLoop {
  std::vector<std::int32_t> half_edges;  ///< each on its boundary edge's only face
  double length = 0;
};

/// Faces with a repeated corner take no part.
class MeshTopology {
 public:
  /// \throws InvalidInput  see inspect()
  explicit MeshTopology(const Mesh& mesh);

  std::vector<MeshEdge> edges;           ///< by a, then b
  std::vector<std::int32_t> half_edges;  ///< edge after edge, ascending within one
  std::vector<char> repeated;            ///< 1: the face has a repeated corner

  std::int32_t from(std::int32_t half_edge) const { return mesh_->faces[half_edge / 3][half_edge % 3]; }
  std::int32_t to(std::int32_t half_edge) const { return mesh_->faces[half_edge / 3][(half_edge + 1) % 3]; }
  /// A face of the part (connected by edges) that face f belongs to: its least.
  std::int32_t part(Index face) const { return parts_.root(static_cast<std::int32_t>(face)); }
  /// A corner of the fan that corner k of face f belongs to: its least.
  std::int32_t fan(Index face, int k) const { return fans_.root(static_cast<std::int32_t>(3 * face + k)); }
  /// Every boundary loop, by part and then the longest first.
  std::vector<BoundaryLoop> loops() const;

 private:
  const Mesh* mesh_;
  DisjointSets parts_, fans_;
};

/// Which faces are to be turned so that all agree: of each part the fewer.
struct Orientation {
  std::vector<char> turn;  ///< a face each
  Index conflict = -1;     ///< a face that cannot agree with its neighbours: not orientable
};
Orientation find_orientation(const Mesh& mesh, const MeshTopology& topology);

/// No area to within rounding: the height over the longest side is at most 8 eps of that side.
bool is_degenerate(const Mesh& mesh, Index face);
double face_area(const Mesh& mesh, Index face);

}  // namespace knotfit
