// A disk mesh over the unit square [METHOD 7.1].
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/mesh.h"
#include "knotfit/points.h"
namespace [[gnu::visibility("default")]] knotfit {

enum class CornerRule {
  automatic,  ///< both, the lower error of a 20 x 20 uniform fit wins
  sharpest,   ///< the four sharpest turns of the boundary
  search      ///< pattern search for the least aspect-free stretch
};

struct MeshMapOptions {
  CornerRule corners = CornerRule::automatic;
  /// Vertices of the four corners: (0,0), (1,0), (1,1), (0,1), in the order of the boundary with the
  /// surface on its left (counter-clockwise from outside); overrides the rule.
  std::optional<std::array<Index, 4>> corner_vertices = {};
  /// Weight of the normals in the metric l^2 = |dx|^2 + omega^2 |dn|^2 (lengths over the diagonal), at most
  /// 10; negative: tried over {0, 0.025, 0.05, 0.1, 0.2} by the error of a 20 x 20 uniform fit.
  double omega = -1;
  bool newton = true;  ///< projected Newton from the mean value map; false: mean value weights alone
  int newton_rounds = 30;
};

/// How a map treats the mesh. 1 is isometric for the stretches; flipped triangles are left out of them,
/// virtual ones of all but `flipped`.
struct MapQuality {
  double stretch = 0;              ///< L2 stretch on the square (Sander)
  double aspect_free_stretch = 0;  ///< L2 stretch on the best rectangle
  double aspect = 1;  ///< width over height of that rectangle: ratio of spans p : q to start from
  /// Least angle between images of orthogonal directions of that rectangle, degrees; 90 conformal.
  double worst_angle = 0;
  Index flipped = 0;  ///< triangles turned over or flat in the square, by exact predicates
};

struct MeshMap {
  std::vector<double> uv;          ///< n x 2, a vertex each, in [0,1]; boundary vertices exactly on the sides
  std::array<Index, 4> corners{};  ///< vertices at (0,0), (1,0), (1,1), (0,1)
  /// Edges inside with both ends on the boundary: between straight sides their triangles cannot all keep
  /// an area, so the map bends such an edge in its middle, halved_uv. halve_edges() makes the mesh that
  /// the map is linear on and `quality` is measured on.
  std::vector<std::array<Index, 2>> halved_edges;
  std::vector<double> halved_uv;  ///< an edge each x 2
  MapQuality quality;
  double omega = 0;                        ///< metric in force
  CornerRule rule = CornerRule::sharpest;  ///< rule that found the corners; as asked where they were given
  /// RMS over the diagonal of a 20 x 20 uniform bicubic fit to the vertices at these parameters (fewer
  /// control points where there are not two vertices for each): at the parameters, and from the vertices
  /// to the surface. The least distance^(3/4) error^(1/4) chooses omega and the corners.
  double trial_error = 0, trial_distance = 0;
  bool stopped = false;  ///< cut short by stop or time: a sound map, not the best

  /// Parameters of the vertices of halve_edges(mesh, halved_edges), (n + halved edges) x 2.
  std::vector<double> all_uv() const {
    std::vector<double> all = uv;
    all.insert(all.end(), halved_uv.begin(), halved_uv.end());
    return all;
  }
};

/// A map of a disk onto the unit square without flipped triangles [Floater03, Yoshizawa04, Lai06, Smith19].
/// The same bits for any number of threads. Where stop or the time limit ends it, the best map so far.
/// \throws InvalidInput  not a disk (require_disk), fewer than four boundary vertices, corners not on the
///   boundary, repeated or out of order, options out of range
MeshMap parameterize_mesh(const Mesh& mesh, const MeshMapOptions& options = {}, const Control& control = {});

/// Quality of any map of the mesh, on its own triangles.
/// \throws InvalidInput  uv is not 2 numbers a vertex, or not finite; no faces
MapQuality measure_map(const Mesh& mesh, const std::vector<double>& uv);

/// Stretch of each face on the best rectangle of `aspect` (MapQuality): the root of the mean square of how
/// many times longer lengths are on the mesh than in the rectangle, over what an even map has. 1 where the
/// map is isometric up to one scale, above 1 where few parameters cover much surface; their mean square by
/// area is the square of the aspect-free stretch. NaN: virtual, flipped or flat.
/// \return a face each
/// \throws InvalidInput  as measure_map
std::vector<double> face_stretches(const Mesh& mesh, const std::vector<double>& uv, double aspect);

/// The mesh with these edges halved: vertex n + k is the middle of edge k, at parameters halved_uv[k].
/// \throws InvalidInput  no face has such an edge
Mesh halve_edges(const Mesh& mesh, const std::vector<std::array<Index, 2>>& edges);

/// The vertices as points with these parameters (dimension 3). Vertices of virtual faces alone are left out.
/// \throws InvalidInput  uv is not 2 numbers a vertex
ParameterizedPoints mesh_points(const Mesh& mesh, const std::vector<double>& uv);

/// Lines u = k / count and v = k / count, k = 0..count, drawn on the mesh: first those of u, each from
/// v = 0 to v = 1, then those of v. A map with flipped triangles can leave lines short.
/// \throws InvalidInput  uv is not 2 numbers a vertex, count < 1
std::vector<std::vector<std::array<double, 3>>> parameter_lines(const Mesh& mesh,
                                                                const std::vector<double>& uv, int count);

}  // namespace knotfit
