#include "parameterize/mesh_mean_value.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "data/orientation.h"
#include "mesh_support.h"
#include "parameterize/mesh_border.h"
namespace knotfit::mesh_map {
namespace {

// Means of mean value weights reproduce every linear function on a plane [Floater03].
TEST(MeanValueMap, ReproducesLinearFunctionsOnAPlane) {
  for (const Mesh& mesh : {test::sheet(9, 7, 2, 1, {}, 0.3), test::dome(6, 17, 0)}) {
    const DiskMesh disk = make_disk(mesh);
    const Elimination elimination(disk.vertex_count(), disk.edge);
    ConvexMap map(disk, elimination);
    ASSERT_TRUE(map.factor(mean_value_weights(disk, rest_triangles(disk, 0))));
    const auto linear = [&](int i) {
      const Position& p = disk.position[i];
      return std::array<double, 2>{0.3 + 2 * p[0] - p[1], p[0] + 0.7 * p[1] - 5};
    };
    std::vector<double> uv(2 * disk.position.size(), 77);
    for (const int i : disk.loop) std::copy_n(linear(i).data(), 2, &uv[2 * i]);
    map.solve(uv);
    for (int i = 0; i < disk.vertex_count(); ++i)
      for (int c = 0; c < 2; ++c) EXPECT_NEAR(uv[2 * i + c], linear(i)[c], 1e-12) << "vertex " << i;
  }
}

TEST(MeanValueMap, MapsASquareToItself) {
  const DiskMesh disk = make_disk(test::sheet(8, 8, 1, 1, {}, 0.2));
  const Elimination elimination(disk.vertex_count(), disk.edge);
  const std::vector<RestTriangle> rest = rest_triangles(disk, 0);
  const Border border(disk, rest);
  std::vector<double> uv(2 * disk.position.size());
  // The loop starts at vertex 0, the corner at the origin.
  border.place({0, 8, 16, 24}, uv);
  ConvexMap map(disk, elimination);
  ASSERT_TRUE(map.factor(mean_value_weights(disk, rest)));
  map.solve(uv);
  const double side = std::sqrt(0.5);  // of a square of diagonal 1
  for (int i = 0; i < disk.vertex_count(); ++i)
    for (int c = 0; c < 2; ++c) EXPECT_NEAR(uv[2 * i + c], disk.position[i][c] / side, 1e-13);
}

TEST(Reweighting, LowersTheStretchOfABump) {
  const DiskMesh disk = make_disk(test::bump(24));
  const Elimination elimination(disk.vertex_count(), disk.edge);
  const std::vector<RestTriangle> rest = rest_triangles(disk, 0);
  const Border border(disk, rest);
  const Corners corners = sharpest_corners(border);
  const Reweighted start = reweight(disk, rest, elimination, border, corners, {.rounds = 1});
  const Reweighted end = reweight(disk, rest, elimination, border, corners, {.slide = 0.5});
  EXPECT_EQ(start.rounds, 0);
  EXPECT_GT(end.rounds, 0);
  EXPECT_LT(end.stretch.aspect_free, 0.9 * start.stretch.aspect_free);
  EXPECT_EQ(count_flipped(disk.face, end.uv), 0);
}

}  // namespace
}  // namespace knotfit::mesh_map
