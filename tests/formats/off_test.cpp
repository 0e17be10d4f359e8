#include <array>

#include "support.h"
namespace knotfit::test {
namespace {

using Faces = std::vector<std::array<std::int32_t, 3>>;

Mesh mesh(const std::string& name, const std::string& bytes) {
  return content<Mesh>(read(name, bytes));
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

}  // namespace
}  // namespace knotfit::test
