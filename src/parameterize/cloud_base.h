// Surfaces that a cloud is projected to.
#pragma once
#include <span>
#include <vector>

#include "parameterize/cloud_neighbours.h"
namespace knotfit::cloud {

/// Places of the points on a base: coordinates with lengths as in space.
struct BasePlaces {
  std::vector<double> at;  ///< n x 2
  Vector centre{}, axis{};
  double radius = 0, scatter = 0;
};

/// By principal axes; coordinates along the sides of the smallest rectangle around the points, the longer side
/// first. \throws InvalidInput  all points at one place or on one line
BasePlaces project_to_plane(std::span<const double> points);

/// The cylinder of least squared distances, from the axis that the normals are most perpendicular to; the angle, cut in
/// its largest gap, times the radius, and the height.
/// \throws InvalidInput  the points lie on no cylinder: its radius would be many times their size
BasePlaces project_to_cylinder(std::span<const double> points, const std::vector<Vector>& normals);

/// Mirrors the places where most of the normals given point below the plane, or into the cylinder.
/// \param given  n x 3, 0: unknown; or empty
void turn_to_normals(BasePlaces& places, std::span<const double> points, std::span<const double> given);

}  // namespace knotfit::cloud
