// Small meshes made by the tests.
#pragma once
#include <cmath>
#include <cstdint>

#include "knotfit/mesh.h"
namespace knotfit::test {

/// A sheet of n x m cells, two triangles each, in [0,1]^2 with a wave in z.
inline Mesh sheet(int n, int m) {
  Mesh mesh;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / m;
      mesh.vertices.insert(mesh.vertices.end(), {x, y, 0.1 * std::sin(3 * x + y)});
    }
  for (std::int32_t j = 0; j < m; ++j)
    for (std::int32_t i = 0; i < n; ++i) {
      const std::int32_t a = j * (n + 1) + i, b = a + n + 1;
      mesh.faces.push_back({a, a + 1, b + 1});
      mesh.faces.push_back({a, b + 1, b});
    }
  return mesh;
}

/// Without the two triangles of some cells of a sheet of n columns.
inline Mesh with_hole(Mesh mesh, int n, std::initializer_list<std::pair<int, int>> cells) {
  std::vector<std::array<std::int32_t, 3>> faces;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    bool gone = false;
    for (const auto& [i, j] : cells) gone = gone || f / 2 == j * n + i;
    if (!gone) faces.push_back(mesh.faces[static_cast<std::size_t>(f)]);
  }
  mesh.faces = faces;
  return mesh;
}

/// A band of n cells, its ends joined; twisted: a Moebius band.
inline Mesh band(int n, bool twisted) {
  Mesh mesh;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * 3.14159265358979 * i / n, half = twisted ? t / 2 : 0;
    for (const double s : {-0.3, 0.3}) {
      const double r = 1 + s * std::cos(half);
      mesh.vertices.insert(mesh.vertices.end(),
                           {r * std::cos(t), r * std::sin(t), s * (twisted ? std::sin(half) : 1)});
    }
  }
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t a = 2 * i, b = a + 1;
    std::int32_t c = 2 * ((i + 1) % n), d = c + 1;
    if (twisted && i == n - 1) std::swap(c, d);
    mesh.faces.push_back({a, c, d});
    mesh.faces.push_back({a, d, b});
  }
  return mesh;
}

/// A torus of n x m cells; without one triangle it has one boundary loop and a handle.
inline Mesh torus(int n, int m) {
  Mesh mesh;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double s = 6.283185307179586 * i / n, t = 6.283185307179586 * j / m, r = 2 + std::cos(t);
      mesh.vertices.insert(mesh.vertices.end(), {r * std::cos(s), r * std::sin(s), std::sin(t)});
    }
  for (std::int32_t i = 0; i < n; ++i)
    for (std::int32_t j = 0; j < m; ++j) {
      const std::int32_t a = i * m + j, b = (i + 1) % n * m + j, c = (i + 1) % n * m + (j + 1) % m,
                         d = i * m + (j + 1) % m;
      mesh.faces.push_back({a, b, c});
      mesh.faces.push_back({a, c, d});
    }
  return mesh;
}

inline void append(Mesh& mesh, const Mesh& other, double shift) {
  const auto first = static_cast<std::int32_t>(mesh.vertex_count());
  for (std::size_t k = 0; k < other.vertices.size(); ++k)
    mesh.vertices.push_back(other.vertices[k] + (k % 3 == 0 ? shift : 0));
  for (const auto& c : other.faces) mesh.faces.push_back({c[0] + first, c[1] + first, c[2] + first});
}

}  // namespace knotfit::test
