#include "knotfit/parameterize_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/exceptions.h"
#include "parameterize/mesh_candidates.h"
#include "parameterize/mesh_quality.h"
namespace knotfit {
namespace {

using mesh_map::Choices;
using mesh_map::Corners;
using mesh_map::DiskMesh;

constexpr double kMostOmega = 10;

void check_options(const MeshMapOptions& options) {
  if (!std::isfinite(options.omega) || options.omega > kMostOmega)
    throw InvalidInput(
        fmt::format("omega = {} is not a weight of the normals: 0 to {}, usually 0 to 0.2, "
                    "or negative to try several",
                    options.omega, kMostOmega));
  if (options.newton_rounds < 0)
    throw InvalidInput(fmt::format("{} rounds of Newton: a count cannot be negative", options.newton_rounds));
}

// Places of the given vertices along the loop.
Corners given_corners(const DiskMesh& disk, const std::array<Index, 4>& vertices) {
  Corners corners;
  for (int k = 0; k < 4; ++k) {
    const Index vertex = vertices[k];
    if (vertex < 0 || vertex >= disk.own)
      throw InvalidInput(fmt::format("corner {}: there is no vertex {}; the mesh has {}, counted from 0",
                                     k + 1, vertex, disk.own));
    const auto at = std::find(disk.loop.begin(), disk.loop.end(), static_cast<int>(vertex));
    if (at == disk.loop.end())
      throw InvalidInput(fmt::format("corner {}: vertex {} is not on the boundary; choose boundary vertices",
                                     k + 1, vertex));
    corners[k] = static_cast<int>(at - disk.loop.begin());
    for (int other = 0; other < k; ++other)
      if (vertices[other] == vertex)
        throw InvalidInput(
            fmt::format("corners {} and {} are both vertex {}; they must differ", other + 1, k + 1, vertex));
  }
  const int n = static_cast<int>(disk.loop.size());
  int around = 0;
  for (int k = 0; k < 4; ++k) around += (corners[(k + 1) % 4] - corners[k] + n) % n;
  if (around != n) {
    std::array<int, 4> order{0, 1, 2, 3};
    std::sort(order.begin() + 1, order.end(), [&](int a, int b) {
      return (corners[a] - corners[0] + n) % n < (corners[b] - corners[0] + n) % n;
    });
    throw InvalidInput(fmt::format(
        "corners {}, {}, {}, {} do not go round the boundary with the surface on the left; in order they are "
        "{}, {}, {}, {}",
        vertices[0], vertices[1], vertices[2], vertices[3], vertices[order[0]], vertices[order[1]],
        vertices[order[2]], vertices[order[3]]));
  }
  return corners;
}

Choices choices_of(const MeshMapOptions& options, const DiskMesh& disk) {
  Choices choices;
  if (options.omega < 0)
    choices.omegas = {0, 0.025, 0.05, 0.1, 0.2};
  else
    choices.omegas = {options.omega};
  choices.rule = options.corners;
  if (options.corner_vertices) choices.corners = given_corners(disk, *options.corner_vertices);
  choices.newton = options.newton;
  choices.newton_rounds = options.newton_rounds;
  return choices;
}

}  // namespace

MeshMap parameterize_mesh(const Mesh& mesh, const MeshMapOptions& options, const Control& control) {
  check_options(options);
  require_disk(mesh);
  const DiskMesh disk = mesh_map::make_disk(mesh);
  if (disk.loop.size() < 4)
    throw InvalidInput(
        fmt::format("the boundary has {} vertices, and a map onto the square needs four corners; "
                    "split its edges",
                    disk.loop.size()));
  const Choices choices = choices_of(options, disk);

  const Stage stage(control, "map");
  stage.report(0);
  const mesh_map::ChosenMap chosen = best_map(disk, choices, stage);

  MeshMap map;
  map.stopped = stage.over();
  map.quality = measure_quality(disk, chosen.uv);
  map.uv.assign(chosen.uv.begin(), chosen.uv.begin() + 2 * disk.own);
  map.halved_uv.assign(chosen.uv.begin() + 2 * disk.own, chosen.uv.end());
  map.halved_edges = disk.halved;
  for (int k = 0; k < 4; ++k) map.corners[k] = disk.loop[chosen.corners[k]];
  map.omega = chosen.omega;
  map.rule = chosen.rule;
  map.trial_error = chosen.fit.error;
  map.trial_distance = chosen.fit.distance;
  return map;
}

}  // namespace knotfit
