// Pictures of a mesh map: the parameter lines on the mesh, and the mesh in the parameter plane.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "knotfit/mesh.h"
#include "knotfit/picture.h"
namespace [[gnu::visibility("default")]] knotfit {

struct MapPictureInput {
  const Mesh* mesh = nullptr;                    ///< as the map sees it: with the edges halved that it halves
  const std::vector<double>* uv = nullptr;       ///< n x 2, a vertex each
  std::array<Index, 4> corners{-1, -1, -1, -1};  ///< vertices marked (0,0), (1,0), (1,1), (0,1); -1: not
  int parts = 20;                                ///< between lines u = 0 and u = 1, and likewise v; 1 to 200
  std::string title, subtitle;                   ///< drawn on top
};

/// Draws to a .png, .svg or .pdf file image in memory; `extension` with its dot. Faces are coloured by their
/// stretch (face_stretches), virtual ones grey; under it the figures of measure_map.
/// \throws InvalidInput  another extension, sizes outside 200 to 20000, no mesh, parameters that do not fit
///   it or are not finite, no corner of that number, a count of parts outside 1 to 200
std::string draw_map_picture(const MapPictureInput& input, const std::string& extension,
                             const PictureOptions& options = {});

}  // namespace knotfit
