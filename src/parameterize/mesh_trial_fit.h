// How well a plain fit does at the parameters of a map: what omega and the corners are chosen by.
#pragma once
#include <cmath>
#include <span>

#include "parameterize/mesh_disk.h"
namespace knotfit::mesh_map {

/// Root mean squares over the mesh's own vertices, lengths over the diagonal.
struct TrialFit {
  double error = 0;     ///< |S(u_k, v_k) - P_k|, at the map's parameters
  double distance = 0;  ///< from P_k to the surface, by foot points from those parameters
  /// By which maps are chosen, the less the better: what correction of the parameters starts from is the distance, what
  /// a fit at these parameters has is the error. Weights 3 : 1 of their logarithms: on the hammer
  /// the error falls by a third at the same distance, on the mountain by 30 % for 6 % of distance.
  double trial_error() const { return std::pow(distance, 0.75) * std::pow(error, 0.25); }
};

/// A bicubic fit of 20 x 20 control points on uniform knots to the mesh's own vertices (fewer control
/// points where there are not two vertices for each). Both are infinite where it has no solution.
TrialFit trial_fit(const DiskMesh& disk, std::span<const double> uv);

}  // namespace knotfit::mesh_map
