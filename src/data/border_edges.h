// Edges of a mesh's border that lie at the same place.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "data/mesh_topology.h"
namespace knotfit {

/// Vertex a[k] of the first edge is at the place of b[k] of the second.
struct EdgePair {
  std::array<std::int32_t, 2> a{}, b{};
  std::array<std::int32_t, 2> face{};
};

/// Pairs of edges with one face each, of different faces, whose ends lie within the tolerance of each other and
/// within half the shorter edge: enough of them that all edges at one place are joined. In no order that depends on
/// anything but the mesh. O(n log n) for meshes in space.
std::vector<EdgePair> equal_border_edges(const Mesh& mesh, const MeshTopology& topology, double tolerance);

}  // namespace knotfit
