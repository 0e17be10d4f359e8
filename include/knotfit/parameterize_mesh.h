// A disk mesh over the unit square [METHOD 7, "Disk meshes" up to "Correction"].
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/mesh.h"
#include "knotfit/points.h"
namespace knotfit {

enum class CornerRule {
  automatic,  ///< both, the lower error of a 20 x 20 uniform fit wins
  sharpest,   ///< the four sharpest turns of the boundary
  search      ///< pattern search for the least aspect-free stretch
};

struct MeshMapOptions {
  CornerRule corners = CornerRule::automatic;
  /// Vertices of the four corners in boundary order: (0,0), (1,0), (1,1), (0,1); overrides the rule.
  std::optional<std::array<Index, 4>> corner_vertices;
  /// Weight of the normals in the metric l^2 = |dx|^2 + omega^2 |dn|^2 (lengths over the diagonal); negative:
  /// tried over {0, 0.025, 0.05, 0.1, 0.2} by the error of a 20 x 20 uniform fit.
  double omega = -1;
  bool newton = true;        ///< projected Newton from the mean value map; false: mean value weights alone
  int newton_rounds = 30;
};

/// How a map treats the mesh. 1 is isometric for the stretches.
struct MapQuality {
  double stretch = 0;             ///< L2 stretch on the square (Sander)
  double aspect_free_stretch = 0; ///< L2 stretch on the best rectangle
  double aspect = 1;              ///< width over height of that rectangle: ratio of spans p : q to start from
  double worst_angle = 0;         ///< least angle between images of orthogonal directions, degrees; 90 conformal
  Index flipped = 0;              ///< triangles turned over or flat in the square, by exact predicates
};

struct MeshMap {
  std::vector<double> uv;         ///< n x 2, a vertex each
  std::array<Index, 4> corners{}; ///< vertices at (0,0), (1,0), (1,1), (0,1)
  MapQuality quality;
  double omega = 0;               ///< metric in force
  CornerRule rule = CornerRule::sharpest;
  double trial_error = 0;         ///< RMS over the diagonal of a 20 x 20 uniform bicubic fit at these parameters
};

/// \throws InvalidInput  not a disk (require_disk), corners not on the boundary or repeated
MeshMap parameterize_mesh(const Mesh& mesh, const MeshMapOptions& options = {}, const Control& control = {});

/// Quality of any map of the mesh.
MapQuality measure_map(const Mesh& mesh, const std::vector<double>& uv);

/// The vertices as points with these parameters (dimension 3). Vertices of virtual faces alone are left out.
ParameterizedPoints mesh_points(const Mesh& mesh, const std::vector<double>& uv);

}  // namespace knotfit
