// A surface sampled for drawing: a grid that holds every knot line, placed in a scene about the
// origin of radius about 1.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "knotfit/points.h"
#include "knotfit/surface.h"
#include "report/vectors.h"
namespace knotfit::report {

struct SurfaceSamples {
  std::vector<double> u, v;                         ///< grid lines, increasing
  std::vector<Index> knots_u, knots_v;              ///< which of them are knot lines, both ends included
  std::vector<int> multiplicity_u, multiplicity_v;  ///< of those; 1 for the ends
  std::vector<Vec3> position, normal;  ///< u.size() x v.size(); unit normals, zero where degenerate
  std::vector<double> area;            ///< |S_u x S_v| in the scene; 0: not kept
  std::vector<char> kept;              ///< 0: far outside the data, not drawn
  bool cut = false;                    ///< some are not kept
  bool height_field = false;           ///< z over (x, y): drawn with its own scale of z
  Vec3 low, high;                      ///< bounding box in the data's units
  Vec3 centre, scale;                  ///< scene = scale * (data - centre), component by component
  std::string name_x = "x", name_y = "y";

  Index size_u() const { return static_cast<Index>(u.size()); }
  Index size_v() const { return static_cast<Index>(v.size()); }
  Index at(Index i, Index j) const { return i * size_v() + j; }
  Vec3 to_scene(const Vec3& p) const {
    return {scale.x * (p.x - centre.x), scale.y * (p.y - centre.y), scale.z * (p.z - centre.z)};
  }
  /// Lowest and highest corner of the surface's box in the scene.
  Vec3 scene_low() const { return to_scene(low); }
  Vec3 scene_high() const { return to_scene(high); }
  /// How many times taller than against x and y heights are drawn; 1: true to scale.
  double exaggeration() const { return height_field && scale.x > 0 ? scale.z / scale.x : 1; }
};

/// Bounding box of the data, in its units; for height fields only z counts.
struct DataBox {
  Vec3 low, high;
};

/// \param map   the user's parameters, for surfaces of dimension 1
/// \param most  samples wanted a direction; more only where there are more knots
/// \param data  parts of the surface more than a third of the data's extent outside are not kept:
///   where no data is, a surface may swing far off and make all else tiny
/// \throws InvalidInput  the surface is empty or of dimension 2
SurfaceSamples sample_surface(const Surface& surface, const ParameterMap& map, int most,
                              const std::optional<DataBox>& data = {});

}  // namespace knotfit::report
