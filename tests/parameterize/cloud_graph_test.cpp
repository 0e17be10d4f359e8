#include <gtest/gtest.h>

#include <cmath>

#include "clouds.h"
#include "knotfit/exceptions.h"
#include "knotfit/parameterize_cloud.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

TEST(CloudGraph, FollowsACloudThatFolds) {
  Random random;
  const Points p = tilted_tube(random, 4000, 1, 4.5);
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
