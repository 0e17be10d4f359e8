// Clouds that the tests make, and what every map of one is.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "knotfit/parameterize_cloud.h"
#include "support/random_splines.h"
namespace knotfit::test {

using Points = std::vector<double>;  ///< n x 3

struct Window {
  double x, y, radius;
};

/// A wave over the unit square at random places, without those in the windows.
inline Points sheet_with_windows(Random& random, int count, const std::vector<Window>& windows) {
  Points p;
  while (static_cast<int>(p.size()) < 3 * count) {
    const double x = random.unit(), y = random.unit();
    if (std::none_of(windows.begin(), windows.end(),
                     [&](const Window& w) { return std::hypot(x - w.x, y - w.y) < w.radius; }))
      p.insert(p.end(), {x, y, 0.1 * std::sin(3 * x) * std::cos(2 * y)});
  }
  return p;
}

/// A wave over a grid of columns x rows with these steps, turned by an angle, from some place on.
inline Points wave_grid(int columns, int rows, double dx, double dy, double angle = 0, double far = 0,
                        bool flat = false) {
  Points p;
  const double c = std::cos(angle), s = std::sin(angle), height = 0.15 * std::min(columns * dx, rows * dy);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = i * dx, y = j * dy;
      const double z = flat ? 0 : height * std::sin(3.0 * i / columns) * std::cos(2.0 * j / rows);
      p.insert(p.end(), {far + c * x - s * y, far + s * x + c * y, z});
    }
  return p;
}

/// Part of a tube of this radius: angle from 0 to `turn`, height 0 to 3.
inline Points tilted_tube(Random& random, int count, double radius, double turn) {
  Points p;
  for (int k = 0; k < count; ++k) {
    const double a = turn * random.unit(), h = 3 * random.unit();
    // Around the axis (0.6, 0, 0.8).
    const double x = radius * std::cos(a), y = radius * std::sin(a);
    p.insert(p.end(), {100 + 0.8 * x + 0.6 * h, -50 + y, -0.6 * x + 0.8 * h});
  }
  return p;
}

/// A map into the square, no triangle turned over.
inline void expect_sound(const CloudMap& c) {
  ASSERT_EQ(static_cast<Index>(c.map.uv.size()), 2 * c.mesh.vertex_count());
  EXPECT_EQ(c.mesh.virtual_face.size(), c.mesh.faces.size());
  for (const double x : c.map.uv) EXPECT_TRUE(x >= 0 && x <= 1);
  EXPECT_EQ(c.map.quality.flipped, 0);
  EXPECT_EQ(measure_map(c.mesh, c.map.uv).flipped, 0);
}

/// Triangles without data.
inline Index count_virtual(const CloudMap& c) {
  return std::count(c.mesh.virtual_face.begin(), c.mesh.virtual_face.end(), 1);
}

}  // namespace knotfit::test
