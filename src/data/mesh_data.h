// What of a mesh is data, and how parameters belong to it.
#pragma once
#include <span>
#include <vector>

#include "base/vec3.h"
#include "knotfit/mesh.h"
namespace knotfit {

inline bool is_data(const Mesh& mesh, Index face) {
  return mesh.virtual_face.empty() || !mesh.virtual_face[face];
}

/// 1 for every vertex of a face that is data.
std::vector<char> data_vertices(const Mesh& mesh);

std::vector<Vec3> vertex_places(const Mesh& mesh);

/// \throws InvalidInput  uv is not two numbers a vertex
void require_parameters(const Mesh& mesh, std::span<const double> uv);

}  // namespace knotfit
