#include "knotfit/parameterize_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "clouds.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

/// A wave over [0, width] x [0, 1], at random places, somewhere far away and turned.
Points wave(Random& random, int count, double width = 2, double far = 4.6e6) {
  Points p;
  for (int k = 0; k < count; ++k) {
    const double x = width * random.unit(), y = random.unit(), z = 0.1 * std::sin(3 * x) * std::cos(4 * y);
    p.insert(p.end(), {far + 0.6 * x - 0.8 * y, far + 0.8 * x + 0.6 * y, z});
  }
  return p;
}

TEST(CloudOverAPlane, FillsTheSquareAlongItsOwnSides) {
  Random random;
  const Points p = wave(random, 2000);
  const CloudMap c = parameterize_cloud(p, {.base = CloudBase::plane});
  expect_sound(c);
  EXPECT_EQ(c.base, CloudBase::plane);
  EXPECT_FALSE(c.mapped);
  EXPECT_GT(c.covered, 0.9);
  EXPECT_EQ(c.coincident + c.lone, 0);
  EXPECT_EQ(c.mesh.vertices, p);
  EXPECT_GT(std::abs(c.axis[2]), 0.99);
  // The first parameter runs along the longer side: within the plane's tilt the places are those of the wave.
  double worst = 0;
  for (Index k = 0; k < 2000; ++k) {
    const double x = (0.6 * (p[3 * k] - 4.6e6) + 0.8 * (p[3 * k + 1] - 4.6e6)) / 2;
    const double u = c.map.uv[2 * k];
    worst = std::max(worst, std::min(std::abs(u - x), std::abs(1 - u - x)));
  }
  EXPECT_LT(worst, 0.05);
  EXPECT_NEAR(c.map.quality.aspect, 2, 0.2);
}

TEST(CloudOverAPlane, TheSameBitsEveryTime) {
  Random random;
  const Points p = wave(random, 500);
  const CloudMap a = parameterize_cloud(p), b = parameterize_cloud(p);
  EXPECT_EQ(a.map.uv, b.map.uv);
  EXPECT_EQ(a.mesh.faces, b.mesh.faces);
}

TEST(CloudOverAPlane, GapsAreNoDataAndScrapsAreLeftOut) {
  Points p;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j)
      if (std::hypot(i - 30, j - 30) > 12) p.insert(p.end(), {i * 1.0, j * 1.0, 0.1 * std::sin(0.2 * i)});
  const auto sheet = static_cast<Index>(p.size()) / 3;
  const CloudMap whole = parameterize_cloud(p, {.fill_holes = true});
  expect_sound(whole);
  EXPECT_GT(count_virtual(whole), 0);
  EXPECT_EQ(whole.openings.size(), 1u);
  EXPECT_EQ(whole.lone, 0);
  p.insert(p.end(), {200, 30, 0});
  const CloudMap with = parameterize_cloud(p, {.fill_holes = true});
  expect_sound(with);
  EXPECT_EQ(with.lone, 1);
  EXPECT_EQ(with.openings.size(), 1u);
  EXPECT_EQ(mesh_points(with.mesh, with.map.uv).size(), sheet);
  EXPECT_NE(describe(with).find("1 points left out, apart from the others"), std::string::npos);
}

TEST(CloudOverAPlane, ARoundOutlineIsLaidAlongTheSquare) {
  Random random;
  Points p;
  while (p.size() < 3 * 1500) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    if (std::hypot(x, y) < 1) p.insert(p.end(), {x, y, 0.2 * x * x});
  }
  const CloudMap plane = parameterize_cloud(p, {.base = CloudBase::plane, .fill_holes = true}),
                 own = parameterize_cloud(p);
  EXPECT_NEAR(plane.covered, std::numbers::pi / 4, 0.03);
  EXPECT_NE(describe(plane).find("of the square holds no data"), std::string::npos);
  expect_sound(own);
  EXPECT_TRUE(own.mapped);
  EXPECT_EQ(own.covered, 1);
  EXPECT_EQ(own.base, CloudBase::plane);
  EXPECT_NE(describe(own).find("the outline laid along the square"), std::string::npos);
}

TEST(CloudOverAPlane, EqualPointsCountOnce) {
  Random random;
  Points p = wave(random, 300, 2, 0);
  const Points some(p.begin(), p.begin() + 30);
  p.insert(p.end(), some.begin(), some.end());
  const CloudMap c = parameterize_cloud(p, {.base = CloudBase::plane});
  EXPECT_EQ(c.coincident, 10);
  EXPECT_EQ(mesh_points(c.mesh, c.map.uv).size(), 300);
}

TEST(CloudOverACylinder, IsUnrolled) {
  Random random;
  for (const double turn : {2.0, 4.5, 2 * std::numbers::pi}) {
    const CloudMap c =
        parameterize_cloud(tilted_tube(random, 3000, 1.25, turn), {.base = CloudBase::cylinder});
    expect_sound(c);
    EXPECT_NEAR(c.radius, 1.25, 1e-9);
    EXPECT_NEAR(c.scatter, 0, 1e-9);
    EXPECT_NEAR(std::abs(c.axis[0]), 0.6, 1e-9);
    EXPECT_NEAR(std::abs(c.axis[2]), 0.8, 1e-9);
    // Unrolled it is flat: nothing is stretched.
    EXPECT_NEAR(c.map.quality.aspect_free_stretch, 1, 1e-2);
    EXPECT_NEAR(c.map.quality.aspect, 1.25 * turn / 3, 0.05 * turn);
  }
}

TEST(CloudOverACylinder, AFlatCloudIsNone) {
  Points p;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) p.insert(p.end(), {i * 1.0, j * 1.0, 0.0});
  expect_throw<InvalidInput>([&] { parameterize_cloud(p, {.base = CloudBase::cylinder}); }, "`base = plane`");
}

/// Of the mesh's triangles, (b - a) x (c - a), by the normal of a point of each: how many on its side less how many not.
Index side(const CloudMap& c, const Points& normals) {
  Index sum = 0;
  for (const auto& f : c.mesh.faces) {
    const double *a = c.mesh.vertex(f[0]), *b = c.mesh.vertex(f[1]), *d = c.mesh.vertex(f[2]);
    const Index point = c.mesh.vertex_line[f[0]] - 1;
    if (point < 0) continue;
    double dot = 0;
    for (int x = 0; x < 3; ++x) {
      const int y = (x + 1) % 3, z = (x + 2) % 3;
      dot += normals[3 * point + x] * ((b[y] - a[y]) * (d[z] - a[z]) - (b[z] - a[z]) * (d[y] - a[y]));
    }
    sum += (dot > 0) - (dot < 0);
  }
  return sum;
}

TEST(CloudNormals, SayWhereOutsideIsOnEveryBase) {
  Random random;
  const Points flat = wave(random, 1500, 2, 0), round = tilted_tube(random, 3000, 1, 4.5);
  for (const double sign : {1.0, -1.0})
    for (const CloudBase base : {CloudBase::plane, CloudBase::cylinder, CloudBase::graph}) {
      const Points& p = base == CloudBase::plane ? flat : round;
      CloudOptions options{.base = base, .map = {.newton = false}};
      for (std::size_t k = 0; k < p.size(); k += 3) {
        // Up, or off the axis of the tube; one in ten is not known.
        const double x = p[k] - 100, along = 0.6 * x + 0.8 * p[k + 2];
        const double n[3] = {x - 0.6 * along, p[k + 1] + 50, p[k + 2] - 0.8 * along};
        for (int c = 0; c < 3; ++c)
          options.normals.push_back(k % 30 == 0                ? 0
                                    : base == CloudBase::plane ? sign * (c == 2)
                                                               : 3 * sign * n[c]);
      }
      const CloudMap c = parameterize_cloud(p, options);
      expect_sound(c);
      EXPECT_EQ(c.normals, static_cast<Index>(p.size()) / 3 - (static_cast<Index>(p.size()) + 29) / 30);
      EXPECT_GT(side(c, options.normals), 8 * c.mesh.face_count() / 10)
          << sign << " " << static_cast<int>(base);
      EXPECT_NE(describe(c).find("have normals"), std::string::npos);
    }
  expect_throw<InvalidInput>([&] { parameterize_cloud(flat, {.normals = {1, 2, 3}}); }, "three each");
  CloudOptions infinite;
  infinite.normals.assign(flat.size(), INFINITY);
  expect_throw<InvalidInput>([&] { parameterize_cloud(flat, infinite); }, "normal 1 (from 1)");
}

TEST(Clouds, RefuseWhatIsNone) {
  const auto bad = [](const Points& p, const std::string& words, CloudOptions options = {}) {
    expect_throw<InvalidInput>([&] { parameterize_cloud(p, options); }, words);
  };
  bad({0, 0, 0, 1, 0, 0, 0, 1, 0}, "3 points: a surface needs at least 4");
  bad({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1}, "no points in space");
  bad({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, NAN, 1}, "point 4 (from 1)");
  bad({1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3}, "at one place");
  bad({0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4}, "one straight line");
  bad({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "neighbours", {.neighbours = 2});
  const Points square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  EXPECT_EQ(parameterize_cloud(square).mesh.face_count(), 2);
  expect_throw<InvalidInput>(
      [&] {
        triangulate_parameters(square, Points{0, 0, 1, 0});
      },
      "4 points need 8 parameters");
  expect_throw<InvalidInput>(
      [&] {
        triangulate_parameters(square, Points{0, 0, 1, 0, 0, 1, 1, 1.5});
      },
      "v of point 4 (from 1) is 1.5");
  expect_throw<InvalidInput>(
      [&] {
        triangulate_parameters(square, Points{0, 0, 1, 1, 0.5, 0.5, 0.2, 0.2});
      },
      "straight line");
}

}  // namespace
}  // namespace knotfit::test
