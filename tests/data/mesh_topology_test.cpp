#include "data/mesh_topology.h"

#include <gtest/gtest.h>

#include "meshes.h"
namespace knotfit::test {
namespace {

TEST(DisjointSets, HaveTheirLeastMemberAsRoot) {
  DisjointSets sets(6);
  sets.unite(5, 3);
  sets.unite(1, 4);
  sets.unite(4, 5);
  for (const int k : {1, 3, 4, 5}) EXPECT_EQ(sets.root(k), 1) << k;
  EXPECT_EQ(sets.root(0), 0);
  EXPECT_EQ(sets.root(2), 2);
}

TEST(MeshTopology, EveryHalfEdgeIsOnTheEdgeOfItsVertices) {
  const Mesh mesh = sheet(4, 3);
  const MeshTopology topology(mesh);
  // Euler: vertices - edges + faces = 1 of a disk.
  EXPECT_EQ(mesh.vertex_count() - static_cast<Index>(topology.edges.size()) + mesh.face_count(), 1);
  Index counted = 0;
  for (const MeshEdge& edge : topology.edges) {
    EXPECT_LT(edge.a, edge.b);
    counted += edge.count;
    for (Index k = edge.first; k < edge.first + edge.count; ++k) {
      const std::int32_t h = topology.half_edges[k];
      EXPECT_EQ(std::minmax(topology.from(h), topology.to(h)), std::minmax(edge.a, edge.b));
    }
  }
  EXPECT_EQ(counted, 3 * mesh.face_count());
}

TEST(MeshTopology, LoopsGoRoundTheBorder) {
  Mesh mesh = with_hole(sheet(6, 6), 6, {{2, 2}});
  const MeshTopology topology(mesh);
  const std::vector<BoundaryLoop> loops = topology.loops();
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0].half_edges.size(), 24u) << "the longest first";
  EXPECT_EQ(loops[1].half_edges.size(), 4u);
  EXPECT_GT(loops[0].length, loops[1].length);
}

TEST(MeshTopology, PartsAndFansHaveTheirLeastAsName) {
  Mesh mesh = sheet(2, 2);
  append(mesh, sheet(2, 2), 5);
  const MeshTopology topology(mesh);
  for (Index f = 0; f < mesh.face_count(); ++f) EXPECT_EQ(topology.part(f), f < 8 ? 0 : 8) << f;
  EXPECT_EQ(topology.fan(0, 0), 0);
}

TEST(FindOrientation, TurnsTheFewerOfEachPart) {
  Mesh mesh = sheet(3, 3);
  std::swap(mesh.faces[4][1], mesh.faces[4][2]);
  const Orientation orientation = find_orientation(mesh, MeshTopology(mesh));
  EXPECT_EQ(orientation.conflict, -1);
  for (Index f = 0; f < mesh.face_count(); ++f) EXPECT_EQ(orientation.turn[f], f == 4 ? 1 : 0) << f;
  const Mesh moebius = band(12, true);
  EXPECT_GE(find_orientation(moebius, MeshTopology(moebius)).conflict, 0);
}

}  // namespace
}  // namespace knotfit::test
