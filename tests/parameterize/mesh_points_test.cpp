#include <gtest/gtest.h>

#include <vector>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize_mesh.h"
#include "parameterize/mesh_support.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

using namespace knotfit::test;

TEST(MeshPoints, AreTheVerticesThatAreData) {
  Mesh mesh = sheet(3, 2);
  std::vector<double> uv;
  for (Index k = 0; k < mesh.vertex_count(); ++k) uv.insert(uv.end(), {mesh.vertex(k)[0], mesh.vertex(k)[1]});
  const ParameterizedPoints points = mesh_points(mesh, uv);
  EXPECT_EQ(points.dimension, 3);
  EXPECT_EQ(points.values, mesh.vertices);
  EXPECT_EQ(points.uv, uv);
  EXPECT_EQ(points.source.front(), 1) << "without lines of a file, numbers from 1";
  // A vertex that virtual faces alone have is none.
  mesh.vertices.insert(mesh.vertices.end(), {0.5, 0.5, 9});
  uv.insert(uv.end(), {0.5, 0.5});
  mesh.virtual_face.assign(mesh.faces.size(), 0);
  mesh.faces.push_back({0, 1, 12});
  mesh.virtual_face.push_back(1);
  EXPECT_EQ(mesh_points(mesh, uv).size(), 12);
}

TEST(HalveEdges, PutsAVertexInTheMiddleAndKeepsTheSurface) {
  Mesh mesh;
  mesh.vertices = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 4};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  const Mesh halved = halve_edges(mesh, {{0, 2}});
  ASSERT_EQ(halved.vertex_count(), 5);
  for (int d = 0; d < 3; ++d) EXPECT_EQ(halved.vertex(4)[d], d < 2 ? 1 : 0);
  using Faces = std::vector<std::array<std::int32_t, 3>>;
  EXPECT_EQ(halved.faces, (Faces{{0, 1, 4}, {0, 4, 3}, {4, 1, 2}, {4, 2, 3}}));
  EXPECT_THROW(halve_edges(mesh, {{1, 3}}), InvalidInput) << "no face has it";
}

}  // namespace
}  // namespace knotfit
