// Fewer vertices of a mesh.
#pragma once
#include <vector>

#include "knotfit/mesh.h"
namespace knotfit {

/// Takes vertices out one by one, each moved into the neighbour that leaves the best triangles (half-edge collapses [Kobbelt98]),
/// never turning a triangle by more than 78 degrees; what that cannot take out stays. Vertices on borders and of virtual faces
/// stay. The topology is the mesh's own, vertex_source and vertex_line are those of the vertices left; parameters are dropped.
/// \param mesh  manifold and oriented
/// \param keep  n; not 0: this vertex stays
Mesh decimate(const Mesh& mesh, const std::vector<char>& keep);

}  // namespace knotfit
