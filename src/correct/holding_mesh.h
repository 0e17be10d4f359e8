// The mesh that a correction works on. Vertices added inside long edges hold the surface where the parameter square has
// few [METHOD 8.2].
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "knotfit/mesh.h"
#include "nearest/foot_points.h"
#include "nearest/map_samples.h"
namespace knotfit::correction {

struct HoldingMesh {
  std::vector<Vec3> position;
  std::vector<std::array<std::int32_t, 3>> face;
  std::vector<char> virtual_face;
  std::vector<std::array<std::int32_t, 2>> border;  ///< boundary edges, the surface on the left
  std::vector<double> uv;                           ///< n x 2
  Index own = 0;                                    ///< vertices from here on are no data
  Index size() const { return static_cast<Index>(position.size()); }
  MapView view() const { return {position, face, virtual_face, uv}; }
};

/// \param own       vertices from here on are no data
/// \param position  of the vertices, in the frame of the mesh
HoldingMesh holding_mesh(const Mesh& mesh, std::vector<Vec3> position, std::vector<double> uv, Index own);

/// Halves the edges longer than `longest_u` or `longest_v` in the parameters until none is left. X(u,v) stays the same.
void halve_long_edges(HoldingMesh& mesh, double longest_u, double longest_v);

/// How each vertex may slide: one on a side of the square along it, one at a corner not at all.
/// \param slide  false: none on a side or corner slides   \param round  they slide past the corners too
std::vector<Slide> slides(const HoldingMesh& mesh, bool slide, bool round);

/// The points are the vertices of faces that are data. One of the mesh itself weighs 1 / n, an added one share * max(its
/// part of the mesh's area, its part of the square).
struct PointWeights {
  std::vector<std::int32_t> vertex;  ///< by point
  std::vector<char> data;            ///< by point: an own vertex
  std::vector<double> area;          ///< by point: part of the mesh's area
  std::vector<double> weight;        ///< by point
};
PointWeights point_weights(const HoldingMesh& mesh);
/// Renews the weights of added vertices after the parameters moved.
void weigh_added(const HoldingMesh& mesh, double share, PointWeights& points);

}  // namespace knotfit::correction
