// The mesh that a correction works on: its vertices, and others inside long edges that hold the surface where the
// parameter square has few of them [METHOD 8.2].
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
/// \param position  of the vertices, in the frame of the correction
HoldingMesh holding_mesh(const Mesh& mesh, std::vector<Vec3> position, std::vector<double> uv, Index own);

/// Halves every edge longer than `longest_u` or `longest_v` in the parameters until none is left; the map as a
/// function stays as it is.
void halve_long_edges(HoldingMesh& mesh, double longest_u, double longest_v);

/// Where each vertex may slide: a boundary vertex on a side along it, one at a corner nowhere.
/// \param round  past the corners
std::vector<Slide> slides(const HoldingMesh& mesh, bool slide, bool round);

/// Weights of the points: 1 / n of each own vertex that a face of the data has; of an added one
/// share * max(its part of the mesh's area, of the square's); 0 where only virtual faces are.
struct PointWeights {
  std::vector<std::int32_t> vertex;  ///< those that count
  std::vector<char> data;            ///< by point: an own vertex
  std::vector<double> area;          ///< by point: part of the mesh's area
  std::vector<double> weight;        ///< by point
};
PointWeights point_weights(const HoldingMesh& mesh);
/// Renews the weights of added vertices for parameters that moved.
void weigh_added(const HoldingMesh& mesh, double share, PointWeights& points);

}  // namespace knotfit::correction
