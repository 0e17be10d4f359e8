#include <gtest/gtest.h>

#include <algorithm>

#include "meshes.h"
#include "repaired.h"
namespace knotfit::test {
namespace {

TEST(MeshRepair, FilledHolesMakeADiskOfVirtualFaces) {
  const Mesh mesh = with_hole(sheet(9, 9), 9, {{2, 2}, {6, 6}, {6, 7}});
  const RepairedMesh out = repair(mesh, {.fill_holes = true});
  EXPECT_EQ(out.summary.filled_holes, 2);
  EXPECT_NO_THROW(require_disk(out.mesh));
  EXPECT_EQ(out.mesh.face_count(), mesh.face_count() + 4 + 6);
  EXPECT_EQ(std::count(out.mesh.virtual_face.begin(), out.mesh.virtual_face.end(), 1), 10);
  EXPECT_EQ(std::count(out.kept.begin(), out.kept.end(), -1), 2);
  EXPECT_EQ(std::count(out.mesh.face_source.begin(), out.mesh.face_source.end(), -1), 10);
  expect_same_places(mesh, out);
}

TEST(MeshRepair, ASlitIsFilledWithoutFlatFaces) {
  // Two copies of the vertices along an inner line: a hole of no width.
  Mesh mesh = sheet(6, 2);
  for (std::size_t k = 2; k < mesh.vertices.size(); k += 3) mesh.vertices[k] = 0;
  const auto n = static_cast<std::int32_t>(mesh.vertex_count());
  for (std::int32_t i = 2; i <= 4; ++i)
    for (int d = 0; d < 3; ++d)
      mesh.vertices.push_back(mesh.vertices[static_cast<std::size_t>(3 * (7 + i) + d)]);
  for (std::size_t f = 12; f < mesh.faces.size(); ++f)  // the upper row has the copies
    for (auto& v : mesh.faces[f])
      if (v >= 9 && v <= 11) v = n + v - 9;
  EXPECT_EQ(inspect(mesh).loop_edges.size(), 2U);
  const RepairedMesh out = repair(mesh, {.fill_holes = true});
  EXPECT_NO_THROW(require_disk(out.mesh));
}

}  // namespace
}  // namespace knotfit::test
