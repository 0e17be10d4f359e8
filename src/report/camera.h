// Where the surface is seen from, and where its points fall on the page.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "report/surface_samples.h"
#include "report/vectors.h"
namespace knotfit::report {

/// A point of the page and how near it is: larger `nearness` hides smaller.
struct ScreenPoint {
  double x = 0, y = 0, nearness = 0;
};

/// Mild perspective onto the page: right, up and toward the eye are orthonormal.
struct Camera {
  Vec3 right{1, 0, 0}, up{0, 1, 0}, toward{0, 0, 1};
  double distance = 10;  ///< of the eye from the scene's origin
  double zoom = 1;       ///< page units a scene unit at the origin
  Vec2 origin;           ///< where the scene's origin falls

  ScreenPoint project(const Vec3& p) const {
    const double nearness = 1 / (distance - dot(p, toward));
    const double s = zoom * distance * nearness;
    return {origin.x + s * dot(p, right), origin.y - s * dot(p, up), nearness};
  }
};

/// Looks along -toward; `upright` points up on the page as far as it can.
Camera look_from(const Vec3& toward, const Vec3& upright);

/// What a view is chosen by: points of the scene, each standing for a part of the surface.
struct ViewScene {
  std::vector<Vec3> position, normal;  ///< unit normals, zero where there is none
  std::vector<double> area;            ///< that a point stands for; 0: not drawn
  std::vector<char> rim;               ///< 1: on the border
  std::vector<std::array<std::int32_t, 3>> triangles;
  Vec3 low, high;  ///< of what is drawn
};

/// Share of the surface's area that the camera sees.
double visible_share(const SurfaceSamples& samples, const Camera& camera);
double visible_share(const ViewScene& scene, const Camera& camera);

/// Height fields: from the south-west, 35 to 45 degrees up, the lowest view that hides little.
/// Others: tilted off the mean normal (or the thinnest principal axis, where the normals cancel)
/// on the side that bulges, the direction that hides least.
Camera choose_view(const SurfaceSamples& samples);
Camera choose_view(const ViewScene& scene);

}  // namespace knotfit::report
