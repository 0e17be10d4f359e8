// Meshes to map: made here, and real ones from a plain reader of this folder's own.
#pragma once
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>
#include <string>

#include "knotfit/mesh.h"
namespace knotfit::test {

/// (columns + 1) x (rows + 1) vertices over [0, width] x [0, height], diagonals in turn; vertex (i, j) is
/// j (columns + 1) + i. `shake` moves inner vertices by that share of a cell.
inline Mesh sheet(int columns, int rows, double width = 1, double height = 1,
                  const std::function<double(double, double)>& z = {}, double shake = 0) {
  Mesh mesh;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> step(-shake, shake);
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const bool inside = i > 0 && j > 0 && i < columns && j < rows;
      const double x = width * (i + (inside ? step(random) : 0)) / columns;
      const double y = height * (j + (inside ? step(random) : 0)) / rows;
      mesh.vertices.insert(mesh.vertices.end(), {x, y, z ? z(x, y) : 0.0});
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const std::int32_t a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = c - 1;
      // Diagonals away from the corners, so that no edge inside joins two boundary vertices.
      const bool left = (i < columns / 2) == (j < rows / 2);
      if (left) {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
      } else {
        mesh.faces.push_back({a, b, d});
        mesh.faces.push_back({b, c, d});
      }
    }
  return mesh;
}

inline Mesh bump(int cells) {
  return sheet(cells, cells, 1, 1, [](double x, double y) {
    return std::exp(-30 * ((x - 0.5) * (x - 0.5) + (y - 0.4) * (y - 0.4)));
  });
}

/// Rings of vertices around a middle one, over a round outline.
inline Mesh dome(int rings, int around, double high) {
  Mesh mesh;
  mesh.vertices = {0, 0, high};
  for (int r = 1; r <= rings; ++r)
    for (int k = 0; k < around; ++k) {
      const double t = static_cast<double>(r) / rings, angle = 2 * M_PI * k / around;
      mesh.vertices.insert(mesh.vertices.end(),
                           {t * std::cos(angle), t * std::sin(angle), high * std::sqrt(1.0001 - t * t)});
    }
  for (int k = 0; k < around; ++k) mesh.faces.push_back({0, 1 + k, 1 + (k + 1) % around});
  for (int r = 1; r < rings; ++r)
    for (int k = 0; k < around; ++k) {
      const std::int32_t a = 1 + (r - 1) * around + k, b = 1 + (r - 1) * around + (k + 1) % around;
      mesh.faces.push_back({a, a + around, b + around});
      mesh.faces.push_back({a, b + around, b});
    }
  return mesh;
}

/// OFF, OBJ (v, f) and binary PLY (x y z floats, faces of 32-bit indices), triangles only.
inline Mesh read_mesh(const std::string& name) {
  const std::string path = std::string(std::getenv("KNOTFIT_DATA")) + "/" + name;
  std::ifstream in(path, std::ios::binary);
  Mesh mesh;
  std::string line, word;
  if (name.ends_with(".off")) {
    Index vertices = 0, faces = 0, skip = 0;
    in >> word >> vertices >> faces >> skip;
    mesh.vertices.resize(static_cast<std::size_t>(3 * vertices));
    for (double& x : mesh.vertices) in >> x;
    mesh.faces.resize(static_cast<std::size_t>(faces));
    for (auto& f : mesh.faces) {
      in >> skip >> f[0] >> f[1] >> f[2];
      std::getline(in, line);
    }
  } else if (name.ends_with(".obj")) {
    while (std::getline(in, line)) {
      std::istringstream s(line);
      s >> word;
      double x = 0, y = 0, z = 0;
      if (word == "v" && s >> x >> y >> z) mesh.vertices.insert(mesh.vertices.end(), {x, y, z});
      if (word != "f") continue;
      std::array<std::int32_t, 3> f{};
      for (auto& i : f) {
        s >> word;
        i = std::atoi(word.c_str()) - 1;
      }
      mesh.faces.push_back(f);
    }
  } else {
    Index vertices = 0, faces = 0;
    while (std::getline(in, line) && line.find("end_header") == std::string::npos) {
      std::istringstream s(line);
      Index count = 0;
      std::string kind;
      if (s >> word >> kind >> count && word == "element") (kind == "vertex" ? vertices : faces) = count;
    }
    std::vector<float> xyz(static_cast<std::size_t>(3 * vertices));
    in.read(reinterpret_cast<char*>(xyz.data()), static_cast<std::streamsize>(4 * xyz.size()));
    mesh.vertices.assign(xyz.begin(), xyz.end());
    mesh.faces.resize(static_cast<std::size_t>(faces));
    for (auto& f : mesh.faces) {
      in.get();
      in.read(reinterpret_cast<char*>(f.data()), 12);
    }
  }
  return mesh;
}

}  // namespace knotfit::test
