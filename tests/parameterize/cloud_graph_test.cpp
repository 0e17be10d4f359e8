#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize_cloud.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using Points = std::vector<double>;

void expect_sound(const CloudMap& c) {
  ASSERT_EQ(static_cast<Index>(c.map.uv.size()), 2 * c.mesh.vertex_count());
  EXPECT_EQ(c.mesh.virtual_face.size(), c.mesh.faces.size());
  for (const double x : c.map.uv) EXPECT_TRUE(x >= 0 && x <= 1);
  EXPECT_EQ(c.map.quality.flipped, 0);
  EXPECT_EQ(measure_map(c.mesh, c.map.uv).flipped, 0);
}

/// Part of a tube of this radius: angle from 0 to `turn`, height 0 to 3.
Points tube(Random& random, int count, double radius, double turn) {
  Points p;
  for (int k = 0; k < count; ++k) {
    const double a = turn * random.unit(), h = 3 * random.unit();
    // Around the axis (0.6, 0, 0.8).
    const double x = radius * std::cos(a), y = radius * std::sin(a);
    p.insert(p.end(), {100 + 0.8 * x + 0.6 * h, -50 + y, -0.6 * x + 0.8 * h});
  }
  return p;
}

TEST(CloudGraph, FollowsACloudThatFolds) {
  Random random;
  const Points p = tube(random, 4000, 1, 4.5);
  const CloudMap c = parameterize_cloud(p);
  expect_sound(c);
  EXPECT_EQ(c.base, CloudBase::graph);
  EXPECT_GT(c.folded, 0.1);
  EXPECT_LT(c.lone, 40);
  // Vertices know which point they are.
  for (Index k = 0; k < c.mesh.vertex_count(); ++k) {
    const Index from = c.mesh.vertex_line[k] - 1;
    if (from < 0) continue;
    for (int d = 0; d < 3; ++d) EXPECT_EQ(c.mesh.vertex(k)[d], p[3 * from + d]);
  }
  EXPECT_LT(c.map.quality.aspect_free_stretch, 1.1);
}

TEST(CloudGraph, SaysWhyThereIsNoSheet) {
  Random random;
  Points fog;
  for (int k = 0; k < 3000; ++k) fog.push_back(random.unit());
  expect_throw<InvalidInput>([&] { parameterize_cloud(fog); }, "fold over their plane");
  expect_throw<InvalidInput>([&] { parameterize_cloud(fog); }, "`height_field`");
  EXPECT_EQ(parameterize_cloud(fog, {.base = CloudBase::plane}).base, CloudBase::plane);
}

}  // namespace
}  // namespace knotfit::test
