// Convex combination maps: mean value weights, and weights made heavier where a map stretches.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "parameterize/mesh_border.h"
#include "parameterize/mesh_factor.h"
namespace knotfit::mesh_map {

/// Weights both ways along every edge (a, b): of b in the row of a, and of a in the row of b.
struct EdgeWeights {
  std::vector<double> forward, backward;
};

/// w_ij = (tan(alpha / 2) + tan(beta / 2)) / l_ij, alpha and beta the angles at i beside the edge
/// [Floater03].
EdgeWeights mean_value_weights(const DiskMesh& disk, const std::vector<RestTriangle>& rest);

/// One factor for all borders: inner vertices are means of their neighbours.
class ConvexMap {
 public:
  ConvexMap(const DiskMesh& disk, const Elimination& elimination) : disk_(disk), lu_(elimination) {}
  /// \return false where the system cannot be factored
  bool factor(const EdgeWeights& weights);
  /// uv holds the boundary's parameters; fills in the others.
  void solve(std::span<double> uv) const;

 private:
  const DiskMesh& disk_;
  DirectedLU lu_;
};

struct Reweighted {
  std::vector<double> uv;
  EdgeWeights weights;  ///< of that map
  Stretch stretch;
  int rounds = 0;
};

struct ReweightOptions {
  double exponent = 0.5;  ///< eta
  double slide = 0;       ///< exponent of the border's lengths; 0: the border stays at arc length
  int rounds = 12;
  std::function<bool()> stop = {};
};

/// w_ij <- w_ij / (s_j / geometric mean s)^eta with s the stretch at each vertex [Yoshizawa04], from
/// mean value weights; the map of least aspect-free stretch. Ends after two rounds without gain.
Reweighted reweight(const DiskMesh& disk, const std::vector<RestTriangle>& rest,
                    const Elimination& elimination, Border border, const Corners& corners,
                    const ReweightOptions& options);

}  // namespace knotfit::mesh_map
