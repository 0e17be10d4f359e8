// A sheet whose parameters are its places.
#pragma once
#include "correct/holding_mesh.h"
#include "data/meshes.h"
namespace knotfit::correction {

/// X(u,v) = (a u, b v, 0) on a sheet.
inline HoldingMesh flat(int cells, double a = 1, double b = 1) {
  const Mesh mesh = test::sheet(cells, cells);
  std::vector<Vec3> position;
  std::vector<double> uv;
  for (Index k = 0; k < mesh.vertex_count(); ++k) {
    const double *p = mesh.vertex(k), x = p[0], y = p[1];
    position.push_back({a * x, b * y, 0});
    uv.insert(uv.end(), {x, y});
  }
  return holding_mesh(mesh, position, uv, mesh.vertex_count());
}

}  // namespace knotfit::correction
