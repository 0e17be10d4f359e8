#include <array>

#include "support.h"
namespace knotfit::test {
namespace {

using Faces = std::vector<std::array<std::int32_t, 3>>;

Mesh mesh(const std::string& name, const std::string& bytes) {
  return content<Mesh>(read(name, bytes));
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
