#include "data/border_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "meshes.h"
namespace knotfit::test {
namespace {

/// Two sheets side by side whose common border each has for itself.
Mesh two_sheets(int n, double apart) {
  Mesh mesh = sheet(n, n), other = sheet(n, n);
  for (Index k = 0; k < other.vertex_count(); ++k)  // a mirror of the first at x = 1
    other.vertices[3 * k] = 2 + apart - other.vertices[3 * k];
  append(mesh, other, 0);
  return mesh;
}

/// The pairs of faces that the pairs of edges join; an edge may stand in several.
std::set<std::pair<std::int32_t, std::int32_t>> joined(const std::vector<EdgePair>& pairs) {
  std::set<std::pair<std::int32_t, std::int32_t>> faces;
  for (const EdgePair& pair : pairs) faces.insert(std::minmax(pair.face[0], pair.face[1]));
  return faces;
}

TEST(EqualBorderEdges, AreThoseAtOnePlace) {
  const Mesh mesh = two_sheets(5, 1e-9);
  const auto pairs = equal_border_edges(mesh, MeshTopology(mesh), 1e-6);
  EXPECT_EQ(joined(pairs).size(), 5u);
  for (const EdgePair& pair : pairs) {
    EXPECT_NE(pair.face[0], pair.face[1]);
    for (int k = 0; k < 2; ++k)
      for (int d = 0; d < 3; ++d) EXPECT_NEAR(mesh.vertex(pair.a[k])[d], mesh.vertex(pair.b[k])[d], 1e-6);
  }
}

TEST(EqualBorderEdges, AreNoneBeyondTheTolerance) {
  const Mesh mesh = two_sheets(5, 1e-3);
  EXPECT_TRUE(equal_border_edges(mesh, MeshTopology(mesh), 1e-6).empty());
  EXPECT_EQ(joined(equal_border_edges(mesh, MeshTopology(mesh), 2e-3)).size(), 5u);
}

// A tolerance wider than the edges must not join an edge to its neighbour.
TEST(EqualBorderEdges, LieWithinHalfTheShorterEdge) {
  const Mesh mesh = sheet(4, 4);
  EXPECT_TRUE(equal_border_edges(mesh, MeshTopology(mesh), 10).empty());
}

}  // namespace
}  // namespace knotfit::test
