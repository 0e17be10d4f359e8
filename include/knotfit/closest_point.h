// Closest points of a surface in space.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/surface.h"
namespace [[gnu::visibility("default")]] knotfit {

struct ClosestPoint {
  double u = 0, v = 0;
  std::array<double, 3> point{};
  double distance = 0;
};

struct ClosestPoints {
  std::vector<double> uv;         ///< n x 2, row-major, in the domain
  std::vector<double> points;     ///< n x 3, S(u,v)
  std::vector<double> distances;  ///< n, |S(u,v) - P|
  bool stopped = false;           ///< cut short: the rest keeps distance infinity
};

/// The closest point of the whole surface. Triangles with a bound on how far the surface leaves them [Filip86]
/// show every place that may be nearest; Newton on |S - P|^2 goes on from there to rounding [Piegl97 6.1].
/// Where the surface is equally near in more than 64 such places, as at the centre of a sphere, one of them
/// within 1e-4 of the surface's size.
/// \throws InvalidInput  a surface that is empty or not in R^3, a point that is not finite
ClosestPoint closest_point(const Surface& surface, const std::array<double, 3>& point);

/// The same for many points, threaded; the same bits for any number of threads.
/// \param points  n x 3, row-major
/// \param start   n x 2 parameters near the answers, where known: faster, never another answer but for ties
/// \throws InvalidInput  as above, naming the point; lengths that do not fit
ClosestPoints closest_points(const Surface& surface, std::span<const double> points,
                             std::span<const double> start = {}, const Control& control = {});

}  // namespace knotfit
