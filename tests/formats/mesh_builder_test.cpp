#include "formats/mesh_builder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

const FileBytes kFile("a.obj", "");

MeshBuilder square(Index counted_from = 1) {
  MeshBuilder builder(kFile, counted_from);
  for (const std::array<double, 3>& p : {std::array<double, 3>{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})
    builder.add_vertex(p.data(), builder.vertex_count() + 1);
  return builder;
}

using Faces = std::vector<std::array<std::int32_t, 3>>;

TEST(MeshBuilder, FansPolygonsIntoTriangles) {
  MeshBuilder builder = square();
  builder.add_face(std::vector<std::int32_t>{0, 1, 2, 3}, 5, 4);
  EXPECT_EQ(builder.face_count(), 1);
  const Mesh mesh = builder.finish();
  EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.counted_from, 1);
  EXPECT_TRUE(builder.notes().empty());
}

TEST(MeshBuilder, CornersParametersAreKeptWhereTheyAgree) {
  MeshBuilder agreeing = square(), parted = square();
  for (MeshBuilder* builder : {&agreeing, &parted}) {
    builder->add_face(std::vector<std::int32_t>{0, 1, 2, 3}, 5, 4);
    for (std::int32_t k = 0; k < 4; ++k) builder->set_corner_parameters(k, k / 4.0, 0.5);
    builder->set_corner_parameters(1, builder == &agreeing ? 0.25 : 0.75, 0.5);
  }
  EXPECT_EQ(agreeing.finish().uv, (std::vector<double>{0, 0.5, 0.25, 0.5, 0.5, 0.5, 0.75, 0.5}));
  EXPECT_TRUE(parted.finish().uv.empty());
  ASSERT_EQ(parted.notes().size(), 1u);
  EXPECT_NE(parted.notes()[0].find("vertex 2 (counted from 1) has several, a seam"), std::string::npos);
}

TEST(MeshBuilder, NamesTheFaceAsTheFileCounts) {
  const auto bad = [](const auto& act, const std::string& words) {
    test::expect_throw<FileError>(act, words);
  };
  const double infinite[] = {0, INFINITY, 0};
  MeshBuilder builder = square(), from_zero = square(0);
  bad([&] { builder.add_vertex(infinite, 9); }, "a.obj:9: vertex 5 (counted from 1): y is not finite");
  bad(
      [&] {
        builder.add_face(std::vector<std::int32_t>{0, 1}, 9, 4);
      },
      "a.obj:9: face 1 (counted from 1) has 2 corners; a face has three or more");
  bad([&] { builder.check_corners(5, 4, 9); }, "has 5 corners, but there are 4 vertices");
  bad([&] { from_zero.corner(4, 4, 9); },
      "face 0 (counted from 0) names vertex 4, but there are 4 vertices, 0 to 3");
  bad([&] { builder.finish(); }, "the mesh has no faces");
  EXPECT_EQ(from_zero.corner(3, 4, 9), 3);
}

TEST(CheckClaim, RefusesMoreThanTheBytesCanHold) {
  check_claim(kFile, 10, "vertices", 6, 60);
  test::expect_throw<FileError>([] { check_claim(kFile, 11, "vertices", 6, 60); },
                                "claims 11 vertices, which take 66 bytes at least, but only 60 bytes");
}

TEST(ForeignKind, KnowsOtherFilesByTheirFirstBytes) {
  EXPECT_EQ(foreign_kind("\x89PNG\r\n"), "a PNG image");
  EXPECT_EQ(foreign_kind("v 0 0 0\n"), "");
}

}  // namespace
}  // namespace knotfit
