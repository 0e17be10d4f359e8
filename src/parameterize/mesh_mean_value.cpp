#include "parameterize/mesh_mean_value.h"

#include <cmath>
#include <utility>
namespace knotfit::mesh_map {

EdgeWeights mean_value_weights(const DiskMesh& disk, const std::vector<RestTriangle>& rest) {
  EdgeWeights weights{std::vector<double>(disk.edge.size(), 0), std::vector<double>(disk.edge.size(), 0)};
  for (int f = 0; f < disk.face_count(); ++f)
    for (int k = 0; k < 3; ++k) {
      // tan(angle / 2) = 2 area / (a b + a . b); the sides at corner k are opposite the other two.
      const double a = rest[f].length[(k + 1) % 3], b = rest[f].length[(k + 2) % 3], c = rest[f].length[k];
      const double cosine = 0.5 * (a * a + b * b - c * c);
      // Near a straight angle the sum cancels: use (ab - a.b) / (2 area) instead.
      const double twice = 2 * rest[f].area;
      const double tangent = cosine > 0 ? twice / (a * b + cosine) : (a * b - cosine) / twice;
      for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
        const int e = disk.face_edge[f][other];
        std::vector<double>& way = disk.edge[e][0] == disk.face[f][k] ? weights.forward : weights.backward;
        way[e] += tangent / rest[f].length[other];
      }
    }
  return weights;
}

bool ConvexMap::factor(const EdgeWeights& weights) {
  std::vector<double> sum(disk_.position.size(), 0);
  for (std::size_t e = 0; e < disk_.edge.size(); ++e) {
    sum[disk_.edge[e][0]] += weights.forward[e];
    sum[disk_.edge[e][1]] += weights.backward[e];
  }
  EdgeWeights rows{std::vector<double>(disk_.edge.size(), 0), std::vector<double>(disk_.edge.size(), 0)};
  for (std::size_t e = 0; e < disk_.edge.size(); ++e) {
    const auto [a, b] = disk_.edge[e];
    if (!disk_.on_boundary[a]) rows.forward[e] = -weights.forward[e] / sum[a];
    if (!disk_.on_boundary[b]) rows.backward[e] = -weights.backward[e] / sum[b];
  }
  return lu_.factor(rows.forward, rows.backward);
}

void ConvexMap::solve(std::span<double> uv) const {
  for (std::size_t i = 0; i < disk_.position.size(); ++i)
    if (!disk_.on_boundary[i]) uv[2 * i] = uv[2 * i + 1] = 0;
  lu_.solve(uv);
}

Reweighted reweight(const DiskMesh& disk, const std::vector<RestTriangle>& rest,
                    const Elimination& elimination, Border border, const Corners& corners,
                    const ReweightOptions& options) {
  ConvexMap map(disk, elimination);
  EdgeWeights weights = mean_value_weights(disk, rest);
  std::vector<double> uv(2 * disk.position.size(), 0);
  Reweighted best;
  int without_gain = 0;
  for (int round = 0; round < options.rounds; ++round) {
    border.place(corners, uv);
    if (!map.factor(weights)) break;
    map.solve(uv);
    const Stretch stretch = measure_stretch(disk, rest, uv);
    if (round == 0 || stretch.cost() < best.stretch.cost()) {
      best = {uv, weights, stretch, round};
      without_gain = 0;
    } else if (++without_gain == 2) {
      break;
    }
    if (stretch.flat || (options.stop && options.stop())) break;
    std::vector<double> local = vertex_stretch(disk, rest, uv, stretch.aspect);
    double mean = 0;
    for (const double s : local) mean += std::log(s);
    mean = std::exp(mean / static_cast<double>(local.size()));
    if (options.slide > 0) {
      std::vector<double> longer(disk.loop.size());
      for (std::size_t k = 0; k < longer.size(); ++k)
        longer[k] =
            std::pow(local[disk.loop[k]] * local[disk.loop[(k + 1) % longer.size()]], options.slide / 2);
      border.stretch(longer);
    }
    for (double& s : local) s = std::pow(s / mean, options.exponent);
    for (std::size_t e = 0; e < disk.edge.size(); ++e) {
      weights.forward[e] /= local[disk.edge[e][1]];
      weights.backward[e] /= local[disk.edge[e][0]];
    }
  }
  return best;
}

}  // namespace knotfit::mesh_map
