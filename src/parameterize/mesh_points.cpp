#include <fmt/format.h>

#include "data/mesh_data.h"
#include "knotfit/exceptions.h"
#include "knotfit/parameterize_mesh.h"
namespace knotfit {

ParameterizedPoints mesh_points(const Mesh& mesh, const std::vector<double>& uv) {
  require_parameters(mesh, uv);
  const std::vector<char> measured = data_vertices(mesh);
  ParameterizedPoints points;
  points.dimension = 3;
  for (Index k = 0; k < mesh.vertex_count(); ++k) {
    if (!measured[k]) continue;
    points.uv.insert(points.uv.end(), {uv[2 * k], uv[2 * k + 1]});
    points.values.insert(points.values.end(), mesh.vertex(k), mesh.vertex(k) + 3);
    points.source.push_back(mesh.vertex_line.empty() ? k + 1 : mesh.vertex_line[k]);
  }
  return points;
}

Mesh halve_edges(const Mesh& mesh, const std::vector<std::array<Index, 2>>& edges) {
  Mesh halved = mesh;
  for (const auto& [a, b] : edges) {
    const auto middle = static_cast<std::int32_t>(halved.vertex_count());
    bool found = false;
    const std::size_t faces = halved.faces.size();
    for (std::size_t f = 0; f < faces; ++f) {
      std::array<std::int32_t, 3> beside_a = halved.faces[f], beside_b = beside_a;
      int ends = 0;
      for (int k = 0; k < 3; ++k) {
        if (halved.faces[f][k] == a) beside_b[k] = middle, ++ends;
        if (halved.faces[f][k] == b) beside_a[k] = middle, ++ends;
      }
      if (ends != 2) continue;
      found = true;
      halved.faces[f] = beside_a;
      halved.faces.push_back(beside_b);
      if (!halved.virtual_face.empty()) halved.virtual_face.push_back(char{halved.virtual_face[f]});
      if (!halved.face_line.empty()) halved.face_line.push_back(Index{halved.face_line[f]});
      if (!halved.face_source.empty()) halved.face_source.push_back(std::int32_t{halved.face_source[f]});
    }
    if (!found) throw InvalidInput(fmt::format("no face has an edge from vertex {} to vertex {}", a, b));
    for (int c = 0; c < 3; ++c)
      halved.vertices.push_back((halved.vertices[3 * a + c] + halved.vertices[3 * b + c]) / 2);
    if (!halved.vertex_line.empty()) halved.vertex_line.push_back(Index{halved.vertex_line[a]});
  }
  halved.uv.clear();
  return halved;
}

}  // namespace knotfit
