#include "data/mesh_data.h"

#include <fmt/format.h>

#include "knotfit/exceptions.h"
namespace knotfit {

std::vector<char> data_vertices(const Mesh& mesh) {
  std::vector<char> result(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (is_data(mesh, f))
      for (const std::int32_t k : mesh.faces[f]) result[k] = 1;
  return result;
}

std::vector<Vec3> vertex_places(const Mesh& mesh) {
  std::vector<Vec3> places;
  places.reserve(static_cast<std::size_t>(mesh.vertex_count()));
  for (Index k = 0; k < mesh.vertex_count(); ++k) places.push_back(at(mesh.vertex(k)));
  return places;
}

void require_parameters(const Mesh& mesh, std::span<const double> uv) {
  if (static_cast<Index>(uv.size()) != 2 * mesh.vertex_count())
    throw InvalidInput(fmt::format("{} vertices need {} parameters, u and v each; there are {}",
                                   mesh.vertex_count(), 2 * mesh.vertex_count(), uv.size()));
}

}  // namespace knotfit
