// Distances between a surface in space and points or a mesh, both ways: the distance from the points alone says
// nothing of a wave or flap of the surface between them.
#pragma once
#include <span>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/mesh.h"
#include "knotfit/surface.h"
namespace [[gnu::visibility("default")]] knotfit {

/// Of distances >= 0, in the data's unit.
struct DistanceSummary {
  Index count = 0;
  double rms = 0, max = 0, mean = 0, median = 0;
  double deviation = 0;               ///< standard deviation of the signed distances about their mean
  double signed_mean = 0;             ///< + where the data lies on the side of the normal
  double p95 = 0, p99 = 0, p995 = 0;  ///< least e with at least that share <= e
  Index worst = -1;  ///< of the points, or of the surface's samples, of which `max` may be beside one
  double worst_u = 0, worst_v = 0;    ///< where on the surface
  double worst_point[3] = {0, 0, 0};  ///< the point, or the surface's
};

struct PointDistances {
  std::vector<double> uv;                ///< n x 2, of the closest points
  std::vector<double> signed_distances;  ///< n, by the surface's normal S_u x S_v, or the data's where given
  DistanceSummary summary;
  bool stopped = false;  ///< cut short; nothing else is filled
};

/// From points to a surface.
/// \param points   n x 3   \param start  n x 2, parameters near the answers, or empty
/// \param normals  n x 3 of the data, for the sign, or empty
/// \throws InvalidInput  no points, lengths that do not fit, what closest_points() refuses
PointDistances point_distances(const Surface& surface, std::span<const double> points,
                               std::span<const double> start = {}, std::span<const double> normals = {},
                               const Control& control = {});

/// Share of the distances that are <= e.
double share_within(const PointDistances& distances, double e);

/// From a surface to a mesh: from samples at the centres of equal parts of every span, about `samples` in each
/// direction, to the nearest triangle. The largest distance, `max` and where it is, is looked for between them too, and along
/// the sides and at the corners: where the samples leave room for 1 % more, finer ones are taken. With the mesh's parameters only samples over its own triangles count:
/// where the mesh has holes the surface is free.
/// \param uv  n x 2, parameters of the vertices, or empty
/// \throws InvalidInput  an empty or flat surface, a mesh without faces, samples < 1
DistanceSummary mesh_distances(const Surface& surface, const Mesh& mesh, std::span<const double> uv = {},
                               int samples = 700, const Control& control = {});

}  // namespace knotfit
