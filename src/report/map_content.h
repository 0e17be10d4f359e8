// What a picture of a mesh map shows, prepared once from its input.
#pragma once
#include <array>
#include <utility>
#include <vector>

#include "knotfit/map_picture.h"
#include "knotfit/parameterize_mesh.h"
#include "report/camera.h"
#include "report/colour_map.h"
#include "report/legend.h"
namespace knotfit::report {

struct MapContent {
  const MapPictureInput* input = nullptr;
  MapQuality quality;
  ViewScene scene;                             ///< the mesh; areas without virtual faces
  Vec3 centre;                                 ///< scene = scale * (data - centre)
  double scale = 1;                            ///<
  std::vector<double> stretch;                 ///< a face each; NaN: none
  double range = 2;                            ///< stretch of the full colour, a power of 2
  bool clipped = false;                        ///< some stretches are beyond it
  bool turned = false, virtual_faces = false;  ///< there are flipped faces, virtual ones
  std::vector<std::vector<Vec3>> lines;        ///< of the scene: parts + 1 of u, then of v
  double plane_aspect = 1;                     ///< width over height that the parameter plane is drawn with

  Vec3 to_scene(const double* p) const { return scale * (Vec3{p[0], p[1], p[2]} - centre); }
  bool is_virtual(Index face) const {
    return !input->mesh->virtual_face.empty() && input->mesh->virtual_face[face];
  }
  Rgb colour(Index face) const;
  /// Border lines are drawn stronger.
  bool border(std::size_t line) const;
};

inline constexpr Rgb kTurned{0.62, 0.05, 0.42};  // a face turned over

/// \throws InvalidInput  as draw_map_picture
MapContent prepare(const MapPictureInput& input);

Facts facts_of(const MapContent& content);

}  // namespace knotfit::report
