// A mesh with a map of its own.
#pragma once
#include "knotfit/mesh.h"
namespace knotfit::test {

/// cells x cells squares of two triangles over [0, width] x [0, 1], height z.
inline Mesh sheet(int cells, double width = 1, double (*z)(double, double) = nullptr) {
  Mesh mesh;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const double u = static_cast<double>(i) / cells, v = static_cast<double>(j) / cells;
      mesh.vertices.insert(mesh.vertices.end(), {width * u, v, z ? z(u, v) : 0.0});
      mesh.uv.insert(mesh.uv.end(), {u, v});
    }
  for (std::int32_t j = 0; j < cells; ++j)
    for (std::int32_t i = 0; i < cells; ++i) {
      const std::int32_t a = j * (cells + 1) + i, b = a + 1, c = b + cells + 1, d = c - 1;
      mesh.faces.push_back({a, b, c});
      mesh.faces.push_back({a, c, d});
    }
  return mesh;
}

}  // namespace knotfit::test
