#include "data/mesh_data.h"

#include <gtest/gtest.h>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

/// A square whose second half closes a hole, and a vertex that no face has.
Mesh half_square() {
  Mesh mesh;
  mesh.vertices = {0, 0, 0, 1, 0, 0, 1, 1, 0.5, 0, 1, 0, 7, 8, 9};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  mesh.virtual_face = {0, 1};
  return mesh;
}

TEST(MeshData, LeavesOutWhatOnlyClosesHoles) {
  Mesh mesh = half_square();
  EXPECT_TRUE(is_data(mesh, 0));
  EXPECT_FALSE(is_data(mesh, 1));
  EXPECT_EQ(data_vertices(mesh), (std::vector<char>{1, 1, 1, 0, 0}));
  mesh.virtual_face.clear();
  EXPECT_TRUE(is_data(mesh, 1));
  EXPECT_EQ(data_vertices(mesh), (std::vector<char>{1, 1, 1, 1, 0}));
}

TEST(MeshData, HasAPlaceForEveryVertex) {
  const std::vector<Vec3> places = vertex_places(half_square());
  ASSERT_EQ(places.size(), 5u);
  EXPECT_EQ(places[2].z, 0.5);
  EXPECT_EQ(places[4].x, 7);
}

TEST(MeshData, NeedsTwoParametersAVertex) {
  const Mesh mesh = half_square();
  EXPECT_NO_THROW(require_parameters(mesh, std::vector<double>(10)));
  expect_throw<InvalidInput>([&] { require_parameters(mesh, std::vector<double>(9)); },
                             "5 vertices need 10 parameters, u and v each; there are 9");
}

}  // namespace
}  // namespace knotfit::test
