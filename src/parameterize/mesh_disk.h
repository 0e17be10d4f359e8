// A disk mesh made ready for maps onto a square.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "knotfit/mesh.h"
namespace knotfit::mesh_map {

using Face = std::array<std::int32_t, 3>;
using Position = std::array<double, 3>;

/// The mesh scaled to a bounding box of diagonal 1. An inner edge with both ends on the boundary is
/// halved, else the triangles at it go flat where both ends come to one side of the square.
struct DiskMesh {
  Index own = 0;                              ///< vertices of the mesh itself; later ones halve edges
  std::vector<Position> position;             ///< lengths over the diagonal
  std::vector<Face> face;                     ///< counter-clockwise
  std::vector<Face> own_face;                 ///< of the mesh itself, before edges are halved
  std::vector<char> virtual_face;             ///< a face each: 1 closes a hole
  std::vector<std::array<Index, 2>> halved;   ///< ends of the edge that vertex own + k halves
  std::vector<int> loop;                      ///< boundary vertices, the surface on the left
  std::vector<char> on_boundary;              ///< a vertex each
  std::vector<std::array<int, 2>> edge;       ///< each once
  std::vector<std::array<int, 3>> face_edge;  ///< edge opposite each corner
  std::vector<int> loop_edge;                 ///< edge from loop[k] to loop[k + 1]
  std::vector<Position> normal;               ///< unit, a vertex each, angle-weighted
  int vertex_count() const { return static_cast<int>(position.size()); }
  int face_count() const { return static_cast<int>(face.size()); }
  /// Weight of a face in energies: virtual ones only have to stay the right way round.
  double weight(int f) const { return virtual_face[f] ? 1e-3 : 1.0; }
};

/// \param mesh  a disk (require_disk)
DiskMesh make_disk(const Mesh& mesh);

/// Positions and faces as they are, of any mesh: no boundary, edges or normals.
DiskMesh faces_alone(const Mesh& mesh);

}  // namespace knotfit::mesh_map
