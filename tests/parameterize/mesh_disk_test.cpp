#include "parameterize/mesh_disk.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh_support.h"
namespace knotfit::mesh_map {
namespace {

TEST(DiskMesh, HalvesEdgesThatCutTheBoundaryOff) {
  // A strip of triangles: every inner edge joins two boundary vertices.
  Mesh strip;
  for (int k = 0; k < 8; ++k)
    strip.vertices.insert(strip.vertices.end(), {k * 0.5, static_cast<double>(k % 2), 0});
  for (int k = 0; k < 6; ++k)
    strip.faces.push_back(k % 2 ? std::array<std::int32_t, 3>{k, k + 2, k + 1}
                                : std::array<std::int32_t, 3>{k, k + 1, k + 2});
  for (auto& f : strip.faces) std::swap(f[1], f[2]);
  const DiskMesh disk = make_disk(strip);
  EXPECT_EQ(disk.own, 8);
  EXPECT_EQ(disk.halved.size(), 5u);
  EXPECT_EQ(disk.vertex_count(), 13);
  EXPECT_EQ(disk.loop.size(), 8u);
  // An edge with both ends on the boundary is one of the boundary.
  std::vector<std::array<int, 2>> around;
  for (const int e : disk.loop_edge) around.push_back(disk.edge[e]);
  for (const auto& [a, b] : disk.edge)
    EXPECT_TRUE(!disk.on_boundary[a] || !disk.on_boundary[b] ||
                std::find(around.begin(), around.end(), std::array<int, 2>{a, b}) != around.end());
}

}  // namespace
}  // namespace knotfit::mesh_map
