#include <gtest/gtest.h>

#include <algorithm>

#include "data/mesh_topology.h"
#include "knotfit/exceptions.h"
#include "meshes.h"
#include "repaired.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

double area(const Mesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) sum += face_area(mesh, f);
  return sum;
}

TEST(MeshRepair, NeedlesAreClosedByMergingTheirVertices) {
  Mesh mesh = sheet(5, 5);
  for (int d = 0; d < 3; ++d)
    mesh.vertices[static_cast<std::size_t>(3 * 15 + d)] = mesh.vertices[static_cast<std::size_t>(3 * 14 + d)];
  const RepairedMesh out = repair(mesh, {.drop_degenerate = true});
  EXPECT_EQ(out.summary.dropped_faces, 2);
  EXPECT_EQ(out.summary.dropped_vertices, 1);
  EXPECT_EQ(out.mesh.face_count(), 48);
  EXPECT_NO_THROW(require_disk(out.mesh));
  expect_same_places(mesh, out);
}

TEST(MeshRepair, ACapGivesItsCornerToTheFaceBeyond) {
  // Vertex 4 lies on the edge 0-2 of face (0, 2, 3): a flat face (0, 4, 2) fills no gap.
  Mesh mesh;
  mesh.vertices = {0, 0, 0, 1, -1, 0, 2, 0, 0, 1, 1, 0, 1, 0, 0};
  mesh.faces = {{0, 1, 4}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}};
  ASSERT_EQ(inspect(mesh).degenerate_face, 2);
  const RepairedMesh out = repair(mesh, {.drop_degenerate = true});
  EXPECT_EQ(out.summary.dropped_faces, 1);
  EXPECT_EQ(out.mesh.face_count(), 4);
  EXPECT_NO_THROW(require_disk(out.mesh));
  EXPECT_NEAR(area(out.mesh), 2, 1e-15);
  EXPECT_EQ(out.mesh.face_source, (std::vector<std::int32_t>{0, 1, 3, 3}));
}

TEST(MeshRepair, ACapAtTheBorderJustGoes) {
  Mesh mesh = sheet(3, 3);
  for (std::size_t k = 2; k < mesh.vertices.size(); k += 3) mesh.vertices[k] = 0;
  mesh.faces.push_back({0, 2, 1});  // beyond the lower border, flat
  const RepairedMesh out = repair(mesh, {.drop_degenerate = true});
  EXPECT_EQ(out.mesh.face_count(), 18);
  EXPECT_NO_THROW(require_disk(out.mesh));
}

TEST(MeshRepair, RandomCollapsedEdgesLeaveADisk) {
  Random random;
  for (int round = 0; round < 100; ++round) {
    Mesh mesh = sheet(8, 8);
    std::vector<char> taken(81, 0);
    // Inner vertices, far from each other, moved onto their right neighbours.
    for (int k = 0; k < 6; ++k) {
      const int i = random.integer(2, 5), j = random.integer(2, 6), v = 9 * j + i;
      bool near = false;
      for (int b = -2; b <= 2; ++b)
        for (int a = -2; a <= 2; ++a)
          near = near ||
                 (v + 9 * b + a >= 0 && v + 9 * b + a < 81 && taken[static_cast<std::size_t>(v + 9 * b + a)]);
      if (near) continue;
      taken[static_cast<std::size_t>(v)] = 1;
      std::copy_n(mesh.vertices.begin() + 3 * (v + 1), 3, mesh.vertices.begin() + 3 * v);
    }
    const RepairedMesh out = repair(mesh, {.drop_degenerate = true});
    EXPECT_NO_THROW(require_disk(out.mesh));
    EXPECT_NEAR(area(out.mesh), area(mesh), 1e-13);
  }
}

TEST(MeshRepair, AFlatMeshLeavesNothing) {
  Mesh mesh;
  mesh.vertices = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0};
  mesh.faces = {{0, 1, 2}, {1, 3, 2}, {0, 0, 1}};
  expect_throw<InvalidInput>([&] { repair(mesh, {.drop_degenerate = true}); }, "nothing is left of the mesh");
}

}  // namespace
}  // namespace knotfit::test
