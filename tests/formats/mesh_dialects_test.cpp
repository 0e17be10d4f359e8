// What other writers put into mesh files: ignored where it can be, and said.
#include <array>

#include "support.h"
namespace knotfit::test {
namespace {

using Faces = std::vector<std::array<std::int32_t, 3>>;

Mesh mesh(const std::string& name, const std::string& bytes) {
  return content<Mesh>(read(name, bytes));
}

/// The notes of a file, one after the other.
std::string notes(const std::string& name, const std::string& bytes) {
  std::string all;
  for (const std::string& note : read(name, bytes).notes) all += note + "\n";
  return all;
}

void expect_note(const std::string& name, const std::string& bytes, const std::string& words) {
  const std::string all = notes(name, bytes);
  EXPECT_NE(all.find(words), std::string::npos) << all << "from " << bytes.substr(0, 200);
}

const std::vector<double> kPlaces = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5};
const Faces kTriangles = {{0, 1, 2}, {0, 2, 3}};

void expect_square(const Mesh& m) {
  EXPECT_EQ(m.vertices, kPlaces);
  EXPECT_EQ(m.faces, kTriangles);
}

TEST(ObjDialects, WhatFollowsThePlaceIsLeftOut) {
  for (const char* more : {"", " nan nan nan", " -nan(ind) 1 0", " 1.0", " 0.5 0.5 0.5 1", " 1e999 0 0",
                           " red", " 1.#QNAN 1.#QNAN 1.#QNAN", " 255 255 255"}) {
    SCOPED_TRACE(more);
    std::string text;
    for (std::size_t k = 0; k < 12; k += 3)
      text += "v " + std::to_string(kPlaces[k]) + ' ' + std::to_string(kPlaces[k + 1]) + ' ' +
              std::to_string(kPlaces[k + 2]) + more + '\n';
    const std::string file = text + "vn nan nan nan\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n";
    expect_square(mesh("a.obj", file));
    EXPECT_EQ(notes("a.obj", file), "");
  }
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\n";

TEST(ObjDialects, WordsItDoesNotKnowAreLeftOutAndSaid) {
  const std::string file = kSquare + "vc 1 2 3\nvc 4 5 6\nfoo\nf 1 2 3 4\n";
  expect_square(mesh("a.obj", file));
  expect_note("a.obj", file, "line 5: \"vc\" is no keyword of an OBJ file: 3 such lines are left out");
  expect_note("a.obj", kSquare + "end\nbevel on\nq 4\nf 1 2 3 4\n",
              "line 7: \"q\" is no keyword of an OBJ file: the line is left out");
}

TEST(ObjDialects, KeywordsMayBeInCapitals) {
  const std::string file =
      "O sheet\nV 0 0 0\nV 1 0 0\nv 1 1 0\nV 0 1 0.5\nVN 0 0 1\nVT 0 0\nVT 1 0\nvt 1 1\nVt 0 1\nUSEMTL grey\n"
      "F 1/1/1 2/2/1 3/3/1\nf -4/-4 -2/-2 -1/-1\n";
  expect_square(mesh("a.obj", file));
  EXPECT_EQ(mesh("a.obj", file).uv, (std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1}));
  EXPECT_EQ(notes("a.obj", file), "");
  // What none of them is stays so, and is told as it is written.
  expect_note("a.obj", kSquare + "Foo 1\nF 1 2 3 4\n",
              "line 5: \"Foo\" is no keyword of an OBJ file: the line is left out");
  EXPECT_EQ(content<PointTable>(read("a.obj", "V 1 2 3\nV 4 5 6\n")).z, (std::vector<double>{3, 6}));
}

TEST(ObjDialects, TextureVerticesThatAreNotThereStopNothing) {
  expect_square(mesh("a.obj", kSquare + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"));
  expect_note("a.obj", kSquare + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n",
              "left aside: line 5: face 1 (counted from 1) names texture vertex 1, but there are 0");
  const std::string vt = "vt 0 0\nvt 1 0\nvt 1 1\nvt nan nan\n";
  expect_square(mesh("a.obj", kSquare + vt + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"));
  expect_note("a.obj", kSquare + vt + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n",
              "left aside: 1 of the vertices has none");
  // So do those that a vertex or a point itself has: a reader hands on finite ones or none.
  const std::string off = "STOFF 3 1 0\n0 0 0 0 0\n1 0 0 1 nan\n0 1 0 0 1\n3 0 1 2\n";
  EXPECT_TRUE(mesh("a.off", off).uv.empty());
  expect_note("a.off", off,
              "the mesh's parameters (texture coordinates) are left aside: 1 of the vertices has none that "
              "is finite");
  const std::string spare = "STOFF 4 1 0\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n9 9 9 nan 1\n3 0 1 2\n";
  EXPECT_EQ(mesh("a.off", spare).uv, (std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0}));
  EXPECT_EQ(notes("a.off", spare), "");
  const std::string cloud = "v 0 0 0\nv 1 0 0\nvt 0 0\nvt /1 0\n";
  EXPECT_TRUE(content<PointTable>(read("a.obj", cloud)).u.empty());
  expect_note(
      "a.obj", cloud,
      "the points' parameters (texture coordinates) are left aside: 1 of the points has none that is finite");
  EXPECT_TRUE(mesh("a.obj", kSquare + vt + "f 1/1 2/2 3/9\nf 1/1 3/3 4/4\n").uv.empty());
  EXPECT_TRUE(mesh("a.obj", kSquare + vt + "f 1/1 2/2 3/0\nf 1/1 3/3 4/4\n").uv.empty());
  EXPECT_TRUE(mesh("a.obj", kSquare + vt + "f 1/1 2/2 3/-9\nf 1/1 3/3 4/4\n").uv.empty());
}

TEST(ObjDialects, ParametersLeftAsideAreSaid) {
  const std::string vt = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0\n";
  expect_note("a.obj", kSquare + vt + "f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n",
              "left aside: one vertex such as vertex 1 (counted from 1) has several, a seam");
  expect_note("a.obj", kSquare + vt + "f 1/1 2/2 3/3\nf 1/5 3/2 4/4\n", "2 vertices such as vertex 1");
  expect_note("a.obj", kSquare + vt + "f 1/1 2/2 3/3\nf 1/1 3/3 4\n",
              "left aside: 1 of the vertices has none");
  EXPECT_EQ(notes("a.obj", kSquare + vt + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"), "");
  EXPECT_EQ(notes("a.obj", kSquare + vt + "f 1 2 3\nf 1 3 4\n"), "");
}

TEST(TextMeshes, MayEndInPadding) {
  for (const std::string& end : {std::string("\x1A"), std::string(7, '\0'), std::string("\n\x1A\0\0", 4)}) {
    expect_square(mesh("a.obj", kSquare + "f 1 2 3 4\n" + end));
    expect_square(mesh("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 .5\n4 0 1 2 3\n" + end));
  }
}

const std::string kBody = "0 0 0\n1 0 0\n1 1 0\n0 1 .5\n3 0 1 2\n3 0 2 3\n";

std::string on_one_line(std::string text) {
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text;
}

TEST(OffDialects, KeywordsInAnyCaseAndCountsInAnyPlace) {
  for (const char* head : {"off\n4 2 0\n", "Off 4 2 5\n", "OFF4 2 5\n", "off4 2\n", "OFF\n4\n2\n0\n",
                           "OFF\n4 2\n", "# made by hand\nOFF # and here\n\n4 2 -1\n", "4 2 0\n",
                           "OFF 4\n2 0\n", "\xEF\xBB\xBFOFF\n4 2 0\n", "noff\n4 2 0\n", "coff\n4 2 0\n"}) {
    SCOPED_TRACE(head);
    expect_square(mesh("a.off", head + kBody));
    EXPECT_EQ(notes("a.off", head + kBody), "");
    std::string dos, mac;
    for (const char c : head + kBody)
      dos += c == '\n' ? "\r\n" : std::string(1, c), mac += c == '\n' ? '\r' : c;
    expect_square(mesh("a.off", dos));
    expect_square(mesh("a.off", mac));
  }
  EXPECT_EQ(read("no extension", "off\n4 2 0\n" + kBody).format, "off");
}

TEST(OffDialects, AllOnOneLineOrAcrossLines) {
  for (const std::string& text :
       {on_one_line("OFF\n4 2 0\n" + kBody), on_one_line("off\n4 2 5\n" + kBody),
        on_one_line("4 2 0\n" + kBody), "OFF 4 2 0\n" + on_one_line(kBody),
        std::string("OFF\n4 2 0\n0 0 0 1 0 0\n1 1 0 0 1 .5\n3 0 1 2\n3 0 2 3\n"),
        std::string("OFF\n4 2 0\n0\n0\n0\n1 0 0\n1 1 0\n0 1 .5\n3 0 1 2\n3 0 2 3\n"),
        std::string("OFF 4 2 0 0 0 0\n1 0 0\n1 1 0\n0 1 .5\n3 0 1 2\n3 0 2 3\n")}) {
    SCOPED_TRACE(text);
    expect_square(mesh("a.off", text));
  }
  // With colours of vertices and of faces, and with parameters.
  expect_square(
      mesh("a.off", on_one_line("COFF\n4 2 0\n0 0 0 9 9 9 1\n1 0 0 9 9 9 1\n1 1 0 9 9 9 1\n0 1 .5 9 9 9 1\n"
                                "3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n")));
  const Mesh m = mesh(
      "a.off", on_one_line("STOFF\n4 2 0\n0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 .5 0 1\n3 0 1 2\n3 0 2 3\n"));
  expect_square(m);
  EXPECT_EQ(m.uv, (std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1}));
  refuses("a.off", on_one_line("OFF\n4 2 0\n0 0 0\n1 0 0\n"), "which take 24 bytes at least");
  refuses("a.off", on_one_line("OFF\n4 2 0\n" + kBody + "3 0 1\n"),
          ":1: the 23 numbers after the counts are not those of 4 vertices and 2 faces");
  refuses("a.off", on_one_line("OFF\n4 2 0\n0 0 0\n1 0 nan\n1 1 0\n0 1 .5\n3 0 1 2\n3 0 2 3\n"),
          "z is not finite");
}

TEST(OffDialects, ColoursAreLeftOutWhateverTheyAre) {
  expect_square(mesh(
      "a.off", "COFF\n4 2 0\n0 0 0 nan nan nan 1\n1 0 0 red\n1 1 0\n0 1 .5 1e999\n3 0 1 2 nan\n3 0 2 3 x\n"));
}

TEST(OffDialects, LinesAfterTheLastFaceAreSaid) {
  expect_square(mesh("a.off", "OFF\n4 2 0\n" + kBody + "3 0 1 3\nend\n"));
  expect_note("a.off", "OFF\n4 2 0\n" + kBody + "3 0 1 3\nend\n",
              "2 lines after the last of 2 faces that the header claims, from line 9: left out");
  expect_note("a.off", "OFF\n4 2 0\n" + kBody + "x\n", "a line after the last of 2 faces");
}

std::string facet(const std::string& a, const std::string& b, const std::string& c,
                  const std::string& loop = "endloop", const std::string& end = "endfacet",
                  const std::string& normal = "facet normal 0 0 1") {
  return " " + normal + "\n  outer loop\n   vertex " + a + "\n   vertex " + b + "\n   vertex " + c + "\n  " +
         loop + "\n " + end + "\n";
}

std::string two(const std::string& loop, const std::string& end,
                const std::string& normal = "facet normal 0 0 1") {
  return facet("0 0 0", "1 0 0", "1 1 0", loop, end, normal) +
         facet("0 0 0", "1 1 0", "0 1 0.5", loop, end, normal);
}

TEST(StlDialects, WordsApartAndInAnyCase) {
  for (const std::string& text :
       {"solid x\n" + two("end loop", "end facet") + "end solid x\n",
        "SOLID\n" + two("EndLoop", "ENDFACET") + "EndSolid\n",
        "solid\n" + two("endloop", "endfacet") + "end solid\n", two("endloop", "endfacet"),
        "\xEF\xBB\xBFsolid x\n" + two("endloop", "endfacet") + "endsolid\n",
        "# by hand\nsolid a facet of mine\n" + two("endloop", "endfacet") + "endsolid a facet of mine\n",
        "solid x\n" + two("endloop", "endfacet", "facet normal nan nan nan") + "endsolid x\n",
        "solid x\n" + two("endloop", "endfacet", "facet normal -nan(ind) 1 1") + "endsolid x\n",
        "solid x\n" + two("endloop", "endfacet", "facet") + "endsolid x\n"}) {
    SCOPED_TRACE(text);
    expect_square(mesh("a.stl", text));
    EXPECT_EQ(notes("a.stl", text), "");
    expect_square(
        mesh("a.stl", on_one_line(text.starts_with('#') ? text.substr(text.find('\n') + 1) : text)));
    std::string mac;
    for (const char c : text) mac += c == '\n' ? '\r' : c;
    expect_square(mesh("a.stl", mac));
    expect_square(mesh("a.stl", text + std::string(100, '\0')));
  }
}

TEST(StlDialects, ColoursAreLeftOut) {
  expect_square(mesh("a.stl", "solid x\n color 0.5 0.5 0.5\n" + two("endloop", "endfacet") + "endsolid x\n"));
  expect_note("a.stl", "solid x\n color 0.5 0.5 0.5\n" + two("endloop", "endfacet") + "endsolid x\n",
              "line 2: \"color\" is no word of an STL file: left out");
  expect_square(mesh("a.stl", "solid x\n" + facet("0 0 0 1 0 0", "1 0 0 nan", "1 1 0 0 0 255") +
                                  facet("0 0 0", "1 1 0", "0 1 0.5") + "endsolid x\n"));
}

TEST(StlDialects, SeveralSolidsAndPolygons) {
  expect_square(mesh("a.stl", "solid a\n" + facet("0 0 0", "1 0 0", "1 1 0") + "endsolid a\n\nsolid b\n" +
                                  facet("0 0 0", "1 1 0", "0 1 0.5") + "endsolid b\n"));
  expect_square(
      mesh("a.stl",
           "solid a\n facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 1 1 0\n"
           " vertex 0 1 0.5\n endloop\n endfacet\nendsolid a\n"));
}

std::string binary(std::uint32_t claimed, const std::string& header, std::size_t facets = 2) {
  const std::vector<double> corners = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0.5};
  std::string out(80, ' ');
  out.replace(0, header.size(), header);
  out += items<std::uint32_t>({static_cast<double>(claimed)});
  for (std::size_t k = 0; k < facets; ++k) {
    out += items<float>({0, 0, 1});
    out += items<float>(
        {corners.begin() + static_cast<Index>(9 * k), corners.begin() + static_cast<Index>(9 * k + 9)});
    out += std::string(2, '\x1F');  // a colour
  }
  return out;
}

TEST(StlDialects, BytesAfterTheLastTriangleAreSaid) {
  for (const char* header : {"made by hand", "solid of a program", "solid", "solid facet vertex"}) {
    expect_square(mesh("a.stl", binary(2, header)));
    EXPECT_EQ(notes("a.stl", binary(2, header)), "");
    for (const std::string& more : {std::string("\n"), std::string(7, '\0'), std::string(512, 'x')}) {
      expect_square(mesh("a.stl", binary(2, header) + more));
      expect_note("a.stl", binary(2, header) + more,
                  std::to_string(more.size()) +
                      " bytes follow the last of the 2 triangles that the header claims: left out");
    }
    EXPECT_EQ(mesh("a.stl", binary(1, header)).face_count(), 1);
    expect_note("a.stl", binary(1, header),
                "50 bytes follow the last of the 1 triangles that the header claims, room for 1 more");
    expect_square(mesh("a.stl", binary(0, header)));
    expect_note("a.stl", binary(0, header),
                "the header claims 0 triangles, but the bytes of 2 follow it: read");
  }
  refuses("a.stl", binary(3, "solid"),
          "claims 3 triangles, which take 150 bytes, but only 100 bytes follow it");
  refuses("a.stl", binary(0, "solid") + "x", "the header claims 0 triangles");
}

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kPlyFaces = "element face 2\nproperty list uchar int vertex_indices\nend_header\n";

TEST(PlyDialects, WhatIsLeftOutMayBeAnything) {
  expect_square(
      mesh("a.ply", kPly + "property float quality\nproperty uchar red\n" + kPlyFaces +
                        "0 0 0 nan 1\n1 0 0 1.#QNAN x\n1 1 0 1e999 2\n0 1 .5 inf 3\n3 0 1 2\n3 0 2 3\n"));
  // A mesh's weights and normals are of no use, and its parameters may be left aside.
  const std::string ply = kPly +
                          "property float nx\nproperty float ny\nproperty float nz\nproperty float w\n"
                          "property float s\nproperty float t\n" +
                          kPlyFaces +
                          "0 0 0 nan nan nan nan 0 0\n1 0 0 0 0 1 1 nan nan\n1 1 0 0 0 1 1 1 1\n"
                          "0 1 .5 0 0 1 1 0 1\n3 0 1 2\n3 0 2 3\n";
  expect_square(mesh("a.ply", ply));
  EXPECT_TRUE(mesh("a.ply", ply).uv.empty());
  expect_note("a.ply", ply, "left aside: 1 of the vertices has none that is finite");
  refuses("a.ply", kPly + kPlyFaces + "0 0 0\n1 0 nan\n1 1 0\n0 1 .5\n3 0 1 2\n3 0 2 3\n", "z is not finite");
}

TEST(PlyDialects, WhatFollowsTheLastRowIsSaid) {
  const std::string rows = "0 0 0\n1 0 0\n1 1 0\n0 1 .5\n3 0 1 2\n3 0 2 3\n";
  expect_square(mesh("a.ply", kPly + kPlyFaces + rows + "\n3 0 1 3\n"));
  expect_note("a.ply", kPly + kPlyFaces + rows + "\n3 0 1 3\n",
              "a line after the last face that the header claims, from line 17: left out");
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\n" +
      kPlyFaces + items<float>(kPlaces);
  for (const auto& face : kTriangles)
    bytes += '\x03' + items<std::int32_t>({static_cast<double>(face[0]), static_cast<double>(face[1]),
                                           static_cast<double>(face[2])});
  expect_square(mesh("a.ply", bytes + "12345"));
  expect_note("a.ply", bytes + "12345", "5 bytes follow the last face that the header claims: left out");
  EXPECT_EQ(notes("a.ply", bytes + "\r\n"), "");
}

TEST(RowsDialects, APoleWrittenOnceStandsForItsRow) {
  const SourceData data =
      read("a.rows", "0 0 1\n\n1 0 0\n0 1 0\n-1 0 0\n\n2 0 -1\n0 2 -1\n-2 0 -1\n\n0 0 -3\n");
  const PointRows rows = content<PointRows>(data);
  EXPECT_EQ(rows.row_start, (std::vector<Index>{0, 3, 6, 9, 12}));
  EXPECT_EQ(std::vector<double>(rows.xyz.begin(), rows.xyz.begin() + 9),
            (std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0, 1}));
  EXPECT_EQ(rows.line, (std::vector<Index>{1, 1, 1, 3, 4, 5, 7, 8, 9, 11, 11, 11}));
  ASSERT_EQ(data.notes.size(), 2U);
  EXPECT_EQ(data.notes[0], "the first row is one point (line 1): a pole, taken for all 3 points of that row");
  EXPECT_EQ(data.notes[1], "the last row is one point (line 11): a pole, taken for all 3 points of that row");
  // Within, one point is no row; of two rows there is no telling.
  EXPECT_EQ(content<PointRows>(read("a.rows", "1 0 0\n0 1 0\n\n2 0 0\n\n3 0 0\n0 3 0\n")).row_start[2], 3);
  EXPECT_EQ(content<PointRows>(read("a.rows", "0 0 1\n\n1 0 0\n0 1 0\n")).row_start[1], 1);
}

}  // namespace
}  // namespace knotfit::test
