// Faces that a file has twice: two-sided models, with shared vertices and with their own.
#include <gtest/gtest.h>

#include <algorithm>

#include "knotfit/exceptions.h"
#include "knotfit/weld_mesh.h"
#include "meshes.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

/// The mesh and its back side, with the same vertices or copies of them; faces side by side where they are mixed.
Mesh two_sided(const Mesh& front, bool own_vertices, bool mixed) {
  Mesh out = front;
  const auto n = static_cast<std::int32_t>(front.vertex_count());
  if (own_vertices) out.vertices.insert(out.vertices.end(), front.vertices.begin(), front.vertices.end());
  out.faces.clear();
  std::vector<std::array<std::int32_t, 3>> back;
  for (std::size_t f = 0; f < front.faces.size(); ++f) {
    auto c = front.faces[f];
    std::array<std::int32_t, 3> turned{c[2], c[1], c[0]};
    if (own_vertices)
      for (std::int32_t& v : turned) v += n;
    // Mixed, the first of each pair is the front of one face and the back of the next.
    if (mixed && f % 2 == 1) std::swap(c, turned);
    out.faces.push_back(c);
    (mixed ? out.faces : back).push_back(turned);
  }
  out.faces.insert(out.faces.end(), back.begin(), back.end());
  return out;
}

TEST(DoubledFaces, OfATwoSidedModelOneSideIsKept) {
  const Mesh front = sheet(6, 5);
  for (const bool own : {false, true})
    for (const bool mixed : {false, true}) {
      SCOPED_TRACE(std::string(own ? "own " : "shared ") + (mixed ? "mixed" : "in turn"));
      Mesh mesh = two_sided(front, own, mixed);
      EXPECT_FALSE(inspect(mesh).disk());
      const DoubledFaces doubled = drop_doubled_faces(mesh);
      EXPECT_EQ(doubled.faces, front.face_count());
      EXPECT_EQ(doubled.reversed, front.face_count());
      weld(mesh, weld_tolerance(mesh));
      EXPECT_EQ(mesh.face_count(), front.face_count());
      EXPECT_EQ(mesh.vertex_count(), front.vertex_count());
      EXPECT_TRUE(inspect(mesh).disk());
      EXPECT_EQ(inspect(mesh).loop_edges, inspect(front).loop_edges);
      if (mixed) continue;
      EXPECT_EQ(mesh.faces, front.faces);
      EXPECT_EQ(mesh.vertices, front.vertices);
    }
}

TEST(DoubledFaces, PolygonsThatAreCutAlongAnotherDiagonalAreTheSame) {
  // A square and a triangle, then both from behind, whose fan has the other diagonal.
  Mesh mesh;
  mesh.vertices = {0, 0, 0, 1, 0, 0, 1, 1, 0.5, 0, 1, 0, 2, 0, 1};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}, {3, 2, 1}, {3, 1, 0}, {2, 4, 1}};
  mesh.face_source = {0, 0, 1, 2, 2, 3};
  const DoubledFaces doubled = drop_doubled_faces(mesh);
  EXPECT_EQ(doubled.faces, 2);
  EXPECT_EQ(doubled.reversed, 2);
  EXPECT_EQ(mesh.faces, (std::vector<std::array<std::int32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}}));
  EXPECT_EQ(mesh.face_source, (std::vector<std::int32_t>{0, 0, 1}));
  EXPECT_TRUE(inspect(mesh).disk());
}

TEST(DoubledFaces, InTheSameOrderTheyAreCountedApart) {
  Mesh mesh = sheet(3, 3);
  const Mesh before = mesh;
  const auto c = mesh.faces[4];
  mesh.faces.push_back({c[1], c[2], c[0]});
  mesh.faces.push_back({c[1], c[0], c[2]});
  const DoubledFaces doubled = drop_doubled_faces(mesh);
  EXPECT_EQ(doubled.faces, 2);
  EXPECT_EQ(doubled.reversed, 1);
  EXPECT_EQ(mesh.faces, before.faces);
}

TEST(DoubledFaces, WhatIsThereOnceStaysAsItIs) {
  // Another vertex, or another place by a last bit, makes another face; one of no area is none at all.
  Mesh mesh = sheet(3, 3);
  mesh.vertices.insert(mesh.vertices.end(), {9, 9, 9});  // used by no face
  mesh.faces.push_back({0, 0, 1});
  mesh.faces.push_back({0, 1, 0});
  const Mesh before = mesh;
  EXPECT_EQ(drop_doubled_faces(mesh).faces, 0);
  EXPECT_EQ(mesh.faces, before.faces);
  EXPECT_EQ(mesh.vertices, before.vertices);
  EXPECT_TRUE(mesh.face_source.empty());
  // A misoriented face that is there once stays so, and is told by inspect().
  Mesh turned = sheet(3, 3);
  std::swap(turned.faces[5][1], turned.faces[5][2]);
  turned.faces.push_back(turned.faces[0]);
  EXPECT_EQ(drop_doubled_faces(turned).faces, 1);
  EXPECT_EQ(inspect(turned).misoriented_face, 5);
  mesh.faces.push_back({0, 1, 99});
  expect_throw<InvalidInput>([&] { drop_doubled_faces(mesh); }, "99");
}

}  // namespace
}  // namespace knotfit::test
