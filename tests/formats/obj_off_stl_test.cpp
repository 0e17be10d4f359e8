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

TEST(OffReader, VerticesAndPolygons) {
  const Mesh m = mesh(
      "a.off",
      "OFF # counts follow\n\n4 2 0\n0 0 0\n1 0 0\n# two more\n1 1 0\n0 1 .5\n3 0 1 2\n4 0 1 2 3 255 0 0\n");
  EXPECT_EQ(m.vertices, (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5}));
  EXPECT_EQ(m.faces, (Faces{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(m.vertex_line, (std::vector<Index>{4, 5, 7, 8}));
  EXPECT_EQ(m.face_line, (std::vector<Index>{9, 10, 10}));
  EXPECT_EQ(m.counted_from, 0);
}

TEST(OffReader, KindsOfHeader) {
  const std::string body = "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* head : {"OFF 3 1 0", "OFF\n3 1", "3 1 0"})
    EXPECT_EQ(mesh("a.off", head + body).face_count(), 1);
  EXPECT_EQ(
      mesh("a.off", "COFF\n3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n").vertex_count(), 3);
  EXPECT_EQ(mesh("a.off", "STOFF\n3 1 0\n0 0 0 .1 .2\n1 0 0 .3 .4\n0 1 0 .5 .6\n3 0 1 2\n").uv,
            (std::vector<double>{.1, .2, .3, .4, .5, .6}));
  EXPECT_EQ(content<PointTable>(read("a.off", "OFF\n2 0 0\n0 0 0\n1 2 3\n")).z, (std::vector<double>{0, 3}));
}

TEST(OffReader, NamesTheLine) {
  const auto bad = [](const std::string& text, const std::string& words) { refuses("a.off", text, words); };
  bad("FFO\n3 1 0\n", ":1: \"FFO\" is not OFF");
  bad("4OFF\n3 1 0\n", "another number of coordinates");
  bad("OFF BINARY\n", "binary OFF is not read");
  bad("XOFF\n3 1 0\n", "no kind of OFF");
  bad("OFF\n", "the file ends before the counts");
  bad("OFF\n-3 1 0\n", ":2: the count of vertices is \"-3\"");
  bad("OFF\n3\n", "the file ends before the counts");
  bad("OFF\n0 0 0\n", "0 vertices");
  bad("OFF\n4000000000 1 0\n0 0 0\n",
      "claims 4000000000 vertices, which take 24000000000 bytes at least, but only 6");
  bad("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", ":4: the vertex has too few numbers");
  bad("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
      ":6: face 0 (counted from 0) names vertex 3, but there are 3 vertices");
  bad("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1    \n", "has 2 corners");
  bad("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n999999 0 1 2\n", "too few numbers for 999999 corners");
  bad("OFF\n3 1 0\n0 0 0     \n1 0 0       \n0 1 0\n", "the file ends before face 0");
  bad("STOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "no texture coordinates");
}

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "  facet normal 0 0 1\n    outer loop\n      vertex " + a + "\n      vertex " + b +
         "\n      vertex " + c + "\n    endloop\n  endfacet\n";
}

std::string binary_stl(const std::vector<float>& corners, std::uint32_t count) {
  std::string out(80, ' ');
  out.replace(0, 5, "solid");
  out += items<std::uint32_t>({static_cast<double>(count)});
  for (std::size_t k = 0; k < corners.size(); k += 9) {
    out += items<float>({0, 0, 1});
    for (std::size_t i = 0; i < 9; ++i) out += items<float>({corners[k + i]});
    out += std::string(2, '\0');
  }
  return out;
}

const std::vector<float> kTwo = {0, 0, 0, 1, 0, 0, 1, 1, 0, -0.0F, 0, 0, 1, 1, 0, 0, 1, 0.5F};

TEST(StlReader, EqualCornersAreOneVertex) {
  const Mesh b = mesh("a.stl", binary_stl(kTwo, 2));
  EXPECT_EQ(b.vertices, (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5}));
  EXPECT_EQ(b.faces, (Faces{{0, 1, 2}, {0, 2, 3}}));
  const Mesh a = mesh("a.stl", "solid some thing\n" + facet("0 0 0", "1 0 0", "1 1 0") +
                                   facet("-0 0 0", "1 1 0", "0 1 0.5") + "endsolid some thing\n");
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.face_line, (std::vector<Index>{2, 9}));
}

TEST(StlReader, NearlyEqualCornersAreTwo) {
  const Mesh m = mesh("a.stl", "SOLID\n" + facet("0 0 0", "1 0 0", "1 1 0") +
                                   facet("1e-300 0 0", "1 1 0", "0 1 0.5") + "ENDSOLID\n");
  EXPECT_EQ(m.vertex_count(), 5);
}

TEST(StlReader, ManyCornersGrowTheTable) {
  std::vector<float> corners;
  for (int k = 0; k < 3000; ++k)
    for (int c = 0; c < 3; ++c)
      corners.insert(corners.end(), {static_cast<float>(k), static_cast<float>(c), 1});
  const Mesh m = mesh("a.stl", binary_stl(corners, 3000));
  EXPECT_EQ(m.vertex_count(), 9000);
  EXPECT_EQ(m.face_count(), 3000);
}

TEST(StlReader, NamesWhatIsWrong) {
  const auto bad = [](const std::string& bytes, const std::string& words) { refuses("a.stl", bytes, words); };
  bad("short", "it has 5 bytes, and neither \"solid\"");
  bad(binary_stl(kTwo, 3),
      "claims 3 triangles, which take 150 bytes, but only 100 bytes follow it (room for 2)");
  bad(binary_stl({}, 0), "claims 0 triangles");
  auto infinite = kTwo;
  infinite[10] = std::numeric_limits<float>::infinity();
  bad(binary_stl(infinite, 2), "triangle 1 (counted from 0): a coordinate is not finite");
  const std::string one = facet("0 0 0", "1 0 0", "1 1 0");
  bad("solid\n" + one, "the file ends before endsolid");
  bad("solid\n" + one.substr(0, one.size() - 12), "the file ends where endfacet is due");
  bad("solid\n" + facet("0 0 0", "1 0 0", "1 1 x") + "endsolid\n", ":6: vertex: \"x\" is not a number");
  bad("solid\n" + facet("0 0 0", "1 0 0", "1 1") + "endsolid\n", ":6: the vertex has too few numbers");
  bad("solid\nouter loop\n", ":2: \"outer\" where facet or endsolid is due");
  bad("solid\nfacet\nvertex 1 2 3\n", ":3: \"vertex\" where outer is due");
  bad("solid\nendsolid\n", "the mesh has no faces");
  bad("solid a\nsolid b\n", ":2: a second solid");
  bad("solid a\nendsolid\nfacet\n", ":3: a facet before solid");
}

}  // namespace
}  // namespace knotfit::test
