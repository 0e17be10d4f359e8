#include <array>

#include "support.h"
namespace knotfit::test {
namespace {

using Faces = std::vector<std::array<std::int32_t, 3>>;

Mesh mesh(const std::string& name, const std::string& bytes) {
  return content<Mesh>(read(name, bytes));
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\n";

TEST(ObjReader, VerticesAndFaces) {
  const Mesh m = mesh("a.obj", "# made by hand\nmtllib a.mtl\no thing\n" + kSquare +
                                   "vn 0 0 1\ns off\nf 1 2 3\nf 1//1 3//1 4//1\n");
  EXPECT_EQ(m.vertices, (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5}));
  EXPECT_EQ(m.faces, (Faces{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(m.vertex_line[0], 4);
  EXPECT_EQ(m.face_line, (std::vector<Index>{10, 11}));
  EXPECT_EQ(m.counted_from, 1);
}

TEST(ObjReader, PolygonsNegativeNumbersAndJoinedLines) {
  const Mesh m = mesh("a.obj", kSquare + "f -4 -3 \\\n -2 -1\nv 9 9 9\nf -5 2 -1 # the last so far\n");
  EXPECT_EQ(m.faces, (Faces{{0, 1, 2}, {0, 2, 3}, {0, 1, 4}}));
  EXPECT_EQ(m.face_source, (std::vector<std::int32_t>{0, 0, 1}));
}

TEST(ObjReader, ParametersWhereEachVertexHasOne) {
  const std::string vt = "vt 0 0\nvt 1 0\nvt 1 1 0\nvt 0 1\nvt 0 0\nvt 0.5 0\n";
  EXPECT_EQ(mesh("a.obj", kSquare + vt + "f 1/1 2/2 3/3\nf 1/5/7 3/-4 4/4\n").uv,
            (std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1}));
  EXPECT_TRUE(mesh("a.obj", kSquare + vt + "f 1/1 2/2 3/3\nf 1/6 3/3 4/4\n").uv.empty()) << "a seam";
  EXPECT_TRUE(mesh("a.obj", kSquare + vt + "f 1/1 2/2 3/3\nf 1/1 3/3 4\n").uv.empty()) << "vertex 4 has none";
}

TEST(ObjReader, PointsWithoutFaces) {
  const PointTable t = content<PointTable>(read("a.obj", "v 1 2 3\nv 4 5 6 0.1 0.2 0.3\nvt 0 1\nvt 1 0\n"));
  EXPECT_EQ(t.y, (std::vector<double>{2, 5}));
  EXPECT_EQ(t.u, (std::vector<double>{0, 1}));
  EXPECT_EQ(t.v, (std::vector<double>{1, 0}));
  EXPECT_TRUE(content<PointTable>(read("a.obj", "v 1 2 3\nv 4 5 6\nvt 0 1\n")).u.empty());
}

TEST(ObjReader, NamesTheLine) {
  const auto bad = [](const std::string& text, const std::string& words) { refuses("a.obj", text, words); };
  bad("f 1 2 3\n", "it has no vertex (v) line");
  bad("v 1 2\n", ":1: the vertex has too few numbers");
  bad("v 1 2 inf\n", ":1: vertex: \"inf\" is not a finite number");
  bad("v 1 2 3,5\n", ":1: vertex: \"3,5\" is not a number");
  bad("v 1 2 3\n7 4\n", ":2: \"7\" is no keyword of an OBJ file");
  bad(kSquare + "f 1 2\n", ":5: face 1 (counted from 1) has 2 corners");
  bad(kSquare + "f 1 2 5\n", ":5: face 1 (counted from 1) names vertex 5, but there are 4, counted from 1");
  bad(kSquare + "f 1 2 3\nf 1 2 0\n", ":6: face 2 (counted from 1) names vertex 0");
  bad(kSquare + "f 1 2 -5\n", "names vertex -5, but only 4 stand before it");
  bad(kSquare + "f 1 2 3 4 1\n", ":5: face 1 (counted from 1) has 5 corners, but there are 4 vertices");
  bad(kSquare + "f 1 2 3.0\n", "\"3.0\" is no number of a vertex");
  bad(kSquare + "f 1 2 99999999999999999999\n", "is no number of a vertex");
  bad(std::string("v 0 0\0 0\n", 9), "byte 5 is zero");
}

}  // namespace
}  // namespace knotfit::test
