// The surface as pixels: depth-tested triangles, coloured and softly lit.
#pragma once
#include <vector>

#include "report/camera.h"
#include "report/canvas.h"
#include "report/content.h"
#include "report/z_buffer.h"
namespace knotfit::report {

/// The triangles of the samples and, under a height field, walls down to its base.
struct SurfaceMesh {
  std::vector<Vec3> position;  ///< samples first, then the walls' feet
  std::vector<Triangle> triangles;
  Index surface_triangles = 0;  ///< the first of them; the rest are walls
};
/// \param base  height of the base in the scene; walls only for height fields
SurfaceMesh make_mesh(const SurfaceSamples& samples, double base);

/// Light on a surface of unit normal n turned to the camera: a soft key light from the upper left and a weak
/// sky; a factor of its colour.
double brightness(const Vec3& n, const Camera& camera);

/// \param corners  the mesh's positions in pixels of `buffer`
/// \param camera   light and facing follow it
/// \param finer    pixels of `buffer` a pixel of the image, averaged
/// \param stripe   distance of hatch lines, in pixels of `buffer`
Image shade(const Content& content, const SurfaceMesh& mesh, const ZBuffer& buffer,
            const std::vector<ScreenPoint>& corners, const Camera& camera, int finer, double stripe);

}  // namespace knotfit::report
