#include <gtest/gtest.h>

#include <numeric>

#include "data/mesh_topology.h"
#include "knotfit/exceptions.h"
#include "meshes.h"
#include "repaired.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

TEST(MeshRepair, NothingAskedChangesNothing) {
  const Mesh mesh = sheet(3, 2);
  const RepairedMesh out = repair(mesh, {});
  EXPECT_EQ(out.mesh.vertices, mesh.vertices);
  EXPECT_EQ(out.mesh.faces, mesh.faces);
  EXPECT_EQ(out.summary.dropped_vertices, 0);
  std::vector<Index> all(static_cast<std::size_t>(mesh.vertex_count()));
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(out.kept, all);
}

TEST(MeshRepair, UnusedVerticesGo) {
  Mesh mesh = sheet(2, 2);
  mesh.vertices.insert(mesh.vertices.begin(), {9, 9, 9});
  for (auto& c : mesh.faces)
    for (auto& v : c) ++v;
  for (Index k = 0; k < mesh.vertex_count(); ++k) {
    mesh.vertex_line.push_back(k + 1);
    mesh.uv.insert(mesh.uv.end(), {static_cast<double>(k), -1.0});
  }
  const RepairedMesh out = repair(mesh, {});
  EXPECT_EQ(out.mesh.vertex_count(), 9);
  EXPECT_EQ(out.kept[0], 1);
  EXPECT_EQ(out.mesh.vertex_line[0], 2);
  EXPECT_EQ(out.mesh.uv[0], 1);
  EXPECT_EQ(out.mesh.vertex_source[0], 1);
  EXPECT_EQ(out.summary.dropped_vertices, 1);
  expect_same_places(mesh, out);
}

TEST(MeshRepair, LargestPartIsByArea) {
  Mesh mesh = sheet(8, 8);  // many faces
  for (double& x : mesh.vertices) x *= 0.1;
  append(mesh, sheet(2, 2), 5);  // few, of more area
  const RepairedMesh out = repair(mesh, {.largest_part = true});
  EXPECT_EQ(out.mesh.face_count(), 8);
  EXPECT_EQ(out.summary.dropped_parts, 1);
  EXPECT_EQ(out.summary.dropped_faces, 128);
  EXPECT_EQ(out.summary.dropped_vertices, 81);
  EXPECT_EQ(out.mesh.face_source[0], 128);
  EXPECT_EQ(out.mesh.vertex_source[0], 81);
  EXPECT_NO_THROW(require_disk(out.mesh));
  expect_same_places(mesh, out);
}

TEST(MeshRepair, MessagesAfterARepairNameTheFilesOwnNumbers) {
  Mesh mesh = sheet(1, 1);
  for (double& x : mesh.vertices) x *= 0.1;
  Mesh other = sheet(4, 4);
  std::swap(other.faces[13][0], other.faces[13][1]);
  append(mesh, other, 5);
  const RepairedMesh out = repair(mesh, {.largest_part = true});
  expect_throw<InvalidInput>([&] { require_disk(out.mesh); }, "face 15 (counted from 0)");
}

TEST(MeshRepair, OrientTurnsTheFewer) {
  Random random;
  for (int round = 0; round < 20; ++round) {
    Mesh mesh = sheet(7, 6);
    const Mesh good = mesh;
    Index turned = 0;
    for (auto& c : mesh.faces)
      if (random.unit() < 0.3) {
        std::swap(c[1], c[2]);
        ++turned;
      }
    if (2 * turned >= mesh.face_count()) continue;
    const RepairedMesh out = repair(mesh, {.orient = true});
    EXPECT_EQ(out.summary.turned_faces, turned);
    EXPECT_EQ(out.mesh.faces, good.faces);
    EXPECT_NO_THROW(require_disk(out.mesh));
  }
}

TEST(MeshRepair, OrientRefusesAMoebiusBand) {
  expect_throw<InvalidInput>([] { repair(band(9, true), {.orient = true}); },
                             "`orient` finds no orientation");
}

TEST(MeshRepair, AnySoupOfFacesComesThrough) {
  // No promise but that it ends, throws nothing but InvalidInput, and names sound vertices.
  Random random;
  for (int round = 0; round < 2000; ++round) {
    Mesh mesh;
    const int n = random.integer(3, 9);
    for (int k = 0; k < 3 * n; ++k) mesh.vertices.push_back(random.integer(0, 3));
    for (int f = random.integer(1, 14); f > 0; --f)
      mesh.faces.push_back({random.integer(0, n - 1), random.integer(0, n - 1), random.integer(0, n - 1)});
    try {
      const RepairedMesh out = repair(mesh, {.largest_part = random.integer(0, 1) == 1,
                                             .fill_holes = random.integer(0, 1) == 1,
                                             .orient = random.integer(0, 1) == 1,
                                             .drop_degenerate = random.integer(0, 2) > 0});
      inspect(out.mesh);
      expect_same_places(mesh, out);
      if (inspect(out.mesh).degenerate_face < 0) {
        EXPECT_EQ(inspect(out.mesh).unused_vertices, 0);
      }
      EXPECT_EQ(out.mesh.face_source.empty() || out.mesh.face_source.size() == out.mesh.faces.size(), true);
    } catch (const InvalidInput&) {
    }
  }
}

TEST(MeshRepair, RefusesListsOfAnotherLength) {
  Mesh mesh = sheet(2, 2);
  mesh.face_line.assign(3, 1);
  expect_throw<InvalidInput>([&] { repair(mesh, {}); }, "of another number");
}

}  // namespace
}  // namespace knotfit::test
