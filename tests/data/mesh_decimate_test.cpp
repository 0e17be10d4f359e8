#include "data/mesh_decimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/vec3.h"
#include "data/mesh_data.h"
#include "meshes.h"
namespace knotfit::test {
namespace {

std::vector<char> every(Index n, Index step) {
  std::vector<char> keep(static_cast<std::size_t>(n), 0);
  for (Index k = 0; k < n; k += step) keep[k] = 1;
  return keep;
}

Vec3 normal(const Mesh& mesh, const std::array<std::int32_t, 3>& f) {
  const std::vector<Vec3> p = vertex_places(mesh);
  return cross(p[f[1]] - p[f[0]], p[f[2]] - p[f[0]]);
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& f : mesh.faces) sum += length(normal(mesh, f)) / 2;
  return sum;
}

TEST(Decimate, KeepsWhatIsToStayAndTheBorder) {
  const Mesh mesh = sheet(40, 30);
  const std::vector<char> keep = every(mesh.vertex_count(), 17);
  const Mesh out = decimate(mesh, keep);
  std::vector<char> left(keep.size(), 0);
  for (Index v = 0; v < out.vertex_count(); ++v) {
    const Index from = out.vertex_source[v];
    left[from] = 1;
    for (int c = 0; c < 3; ++c) EXPECT_EQ(out.vertex(v)[c], mesh.vertex(from)[c]);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index i = v % 41, j = v / 41;
    if (keep[v] != 0 || i == 0 || i == 40 || j == 0 || j == 30) {
      EXPECT_EQ(left[v], 1) << v;
    }
  }
  // Of 1131 inner vertices some 67 are to stay.
  EXPECT_LT(out.vertex_count(), 140 + 67 + 25);
}

TEST(Decimate, LeavesADiskOfTheSameSheet) {
  const Mesh mesh = sheet(40, 30), out = decimate(mesh, every(mesh.vertex_count(), 9));
  EXPECT_TRUE(inspect(out).disk());
  EXPECT_EQ(inspect(out).loop_edges[0], 140);
  EXPECT_EQ(out.face_count(), 2 * (out.vertex_count() - 1) - 140);  // Euler
  EXPECT_NEAR(area(out), area(mesh), 2e-3 * area(mesh));
  for (const auto& f : out.faces) EXPECT_GT(normal(out, f).z, 0);
}

TEST(Decimate, ADomeStaysNearItsSphere) {
  Mesh mesh = sheet(60, 60);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const double x = mesh.vertex(v)[0] - 0.5, y = mesh.vertex(v)[1] - 0.5;
    mesh.vertices[3 * v + 2] = std::sqrt(1 - x * x - y * y);
  }
  const Mesh out = decimate(mesh, every(mesh.vertex_count(), 20));
  double farthest = 0;
  for (const auto& f : out.faces) {
    Vec3 middle{};
    for (const std::int32_t v : f) middle += (1.0 / 3) * vertex_places(out)[v] - Vec3{1.0 / 6, 1.0 / 6, 0};
    farthest = std::max(farthest, 1 - length(middle));
  }
  EXPECT_LT(out.vertex_count(), 240 + 3721 / 20 + 60);
  EXPECT_LT(farthest, 0.02);  // edges of a tenth and a half: h^2 / 8
}

TEST(Decimate, HolesThatAreFilledStayAsTheyAre) {
  Mesh mesh = sheet(20, 20);
  mesh.virtual_face.assign(mesh.faces.size(), 0);
  for (const Index f : {300, 301, 302}) mesh.virtual_face[f] = 1;
  const Mesh out = decimate(mesh, every(mesh.vertex_count(), 1000));
  ASSERT_EQ(out.virtual_face.size(), out.faces.size());
  EXPECT_EQ(std::count(out.virtual_face.begin(), out.virtual_face.end(), 1), 3);
  for (Index f = 0; f < out.face_count(); ++f) {
    if (out.virtual_face[f] == 0) continue;
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(out.vertex_source[out.faces[f][k]], mesh.faces[out.face_source[f]][k]);
  }
}

TEST(Decimate, ATorusKeepsItsHandle) {
  const Mesh mesh = torus(30, 20), out = decimate(mesh, every(mesh.vertex_count(), 1000));
  EXPECT_EQ(inspect(out).euler_characteristic, inspect(mesh).euler_characteristic);
  EXPECT_EQ(inspect(out).nonmanifold_vertex, -1);
  EXPECT_LT(out.vertex_count(), mesh.vertex_count() / 4);
}

TEST(Decimate, AllToStayChangesNothing) {
  const Mesh mesh = sheet(5, 4);
  const Mesh out = decimate(mesh, every(mesh.vertex_count(), 1));
  EXPECT_EQ(out.vertices, mesh.vertices);
  EXPECT_EQ(out.faces, mesh.faces);
}

TEST(Decimate, LinesOfTheFileGoWithTheirVertices) {
  Mesh mesh = sheet(12, 12);
  for (Index v = 0; v < mesh.vertex_count(); ++v) mesh.vertex_line.push_back(100 + v);
  const Mesh out = decimate(mesh, every(mesh.vertex_count(), 7));
  ASSERT_EQ(out.vertex_line.size(), out.vertex_source.size());
  for (Index v = 0; v < out.vertex_count(); ++v) EXPECT_EQ(out.vertex_line[v], 100 + out.vertex_source[v]);
}

}  // namespace
}  // namespace knotfit::test
