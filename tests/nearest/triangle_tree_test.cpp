#include "nearest/triangle_tree.h"

#include <gtest/gtest.h>

#include "support/random_splines.h"
namespace knotfit {
namespace {

using namespace knotfit::test;

struct Soup {
  std::vector<double> vertices;
  std::vector<std::array<std::int32_t, 3>> faces;
};

/// Random triangles, some of them needles, some of no area.
Soup soup(Random& random, int count) {
  Soup s;
  for (int k = 0; k < 3 * count; ++k)
    for (int d = 0; d < 3; ++d) s.vertices.push_back(random.uniform(-1, 1));
  for (std::int32_t k = 0; k < count; ++k) {
    s.faces.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    if (k % 5 == 1)
      for (int d = 0; d < 3; ++d) s.vertices[9 * k + 6 + d] = s.vertices[9 * k + 3 + d] + 1e-9 * d;
    if (k % 7 == 2)
      for (int d = 0; d < 6; ++d) s.vertices[9 * k + 3 + d] = s.vertices[9 * k + d % 3];
  }
  return s;
}

TEST(TriangleTree, WeightsAreThoseOfTheClosestPoint) {
  Random random;
  for (int repeat = 0; repeat < 300; ++repeat) {
    const Soup s = soup(random, 8);
    for (const auto& f : s.faces) {
      const Vec3 a = at(&s.vertices[3 * f[0]]), b = at(&s.vertices[3 * f[1]]), c = at(&s.vertices[3 * f[2]]);
      const Vec3 p{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
      const auto w = closest_weights(p, a, b, c);
      EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-12);
      for (const double x : w) EXPECT_GE(x, -1e-12);
      const double d = length(w[0] * a + w[1] * b + w[2] * c - p);
      // No other point of the triangle is nearer.
      for (int i = 0; i <= 12; ++i)
        for (int j = 0; i + j <= 12; ++j)
          EXPECT_LE(d, length((i / 12.0) * a + (j / 12.0) * b + (1 - (i + j) / 12.0) * c - p) + 1e-7);
    }
  }
}

TEST(TriangleTree, FindsWhatASearchThroughAllFinds) {
  Random random;
  for (const int count : {1, 2, 5, 40, 700}) {
    const Soup s = soup(random, count);
    const TriangleTree tree(s.vertices, s.faces);
    for (int k = 0; k < 200; ++k) {
      const Vec3 p{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
      double least = INFINITY;
      std::vector<double> all;
      for (const auto& f : s.faces) {
        const Vec3 a = at(&s.vertices[3 * f[0]]), b = at(&s.vertices[3 * f[1]]),
                   c = at(&s.vertices[3 * f[2]]);
        const auto w = closest_weights(p, a, b, c);
        all.push_back(squared(w[0] * a + w[1] * b + w[2] * c - p));
        least = std::min(least, all.back());
      }
      const TriangleHit hit = tree.nearest(p), hinted = tree.nearest(p, k % count);
      EXPECT_EQ(hit.squared, least);
      EXPECT_EQ(hit.squared, all[hit.face]);
      EXPECT_EQ(hinted.squared, hit.squared);
      EXPECT_EQ(hinted.face, hit.face);
      const double bound = 1.2 * std::sqrt(least);
      std::size_t inside = 0;
      tree.within(
          p, [&] { return bound; },
          [&](Index face, double d) {
            EXPECT_EQ(d, all[face]);
            inside += d <= bound * bound;
          });
      std::size_t wanted = 0;
      for (const double d : all) wanted += d <= bound * bound;
      EXPECT_EQ(inside, wanted);
    }
  }
}

}  // namespace
}  // namespace knotfit
