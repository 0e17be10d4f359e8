#include <algorithm>

#include "support.h"
namespace knotfit::test {
namespace {

const std::string kVertex = "element vertex 4\nproperty double x\nproperty double y\nproperty double z\n";
const std::string kFace = "element face 2\nproperty list uchar int vertex_indices\n";

std::string ascii(const std::string& header, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

const std::string kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n";
const std::string kTwo = "3 0 1 2\n3 0 2 3\n";

Mesh mesh(const std::string& bytes) {
  return content<Mesh>(read("a.ply", bytes));
}

TEST(PlyReader, TextMesh) {
  const Mesh m = mesh(ascii("comment made by hand\nobj_info none\n" + kVertex + kFace, kSquare + kTwo));
  EXPECT_EQ(m.vertices, (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5}));
  EXPECT_EQ(m.faces, (std::vector<std::array<std::int32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(m.vertex_line, (std::vector<Index>{12, 13, 14, 15}));
  EXPECT_EQ(m.face_line, (std::vector<Index>{16, 17}));
  EXPECT_TRUE(m.face_source.empty());
  EXPECT_TRUE(m.uv.empty());
  EXPECT_EQ(m.counted_from, 0);
}

TEST(PlyReader, AnyLineEnd) {
  const std::string text = ascii(kVertex + kFace, kSquare + kTwo);
  std::string crlf, cr = text;
  for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::replace(cr.begin(), cr.end(), '\n', '\r');
  EXPECT_EQ(mesh(crlf).faces, mesh(text).faces);
  EXPECT_EQ(mesh(cr).vertices, mesh(text).vertices);
}

/// Types and order of properties at random, every encoding: the same mesh.
TEST(PlyReader, AnyPropertyOrderAndTypeInEveryEncoding) {
  for (const bool big : {false, true}) {
    const std::string header =
        std::string("ply\nformat binary_") + (big ? "big" : "little") +
        "_endian 1.0\n"
        "element material 2\nproperty list ushort short ambient\nproperty uchar kind\n"
        "element face 2\nproperty uchar red\nproperty list uint uint16 vertex_index\n"
        "property list char float other\n"
        "element vertex 4\nproperty float64 z\nproperty uint8 alpha\nproperty float x\n"
        "property list uchar uchar near\nproperty int16 y\nproperty float t\nproperty float s\n"
        "end_header\n";
    std::string body;
    const auto put = [&]<class T>(T value) { body += items<T>({static_cast<double>(value)}, big); };
    for (int k = 0; k < 2; ++k) {
      put(std::uint16_t{2}), put(std::int16_t{-5}), put(std::int16_t{7}), put(std::uint8_t{1});
    }
    for (int f = 0; f < 2; ++f) {
      put(std::uint8_t{200}), put(std::uint32_t{3});
      for (const int v : {0, f + 1, f + 2}) put(static_cast<std::uint16_t>(v));
      put(std::int8_t{1}), put(2.5F);
    }
    const double at[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}};
    for (const auto& p : at) {
      put(p[2]), put(std::uint8_t{9}), put(static_cast<float>(p[0]));
      put(std::uint8_t{2}), put(std::uint8_t{1}), put(std::uint8_t{1});
      put(static_cast<std::int16_t>(p[1])), put(static_cast<float>(p[1])), put(static_cast<float>(p[0]));
    }
    const Mesh m = mesh(header + body);
    EXPECT_EQ(m.vertices, (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5}));
    EXPECT_EQ(m.faces, (std::vector<std::array<std::int32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(m.uv, (std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1}));
    EXPECT_TRUE(m.face_line.empty());
    EXPECT_EQ(read("a.ply", header + body + "x").notes,
              std::vector<std::string>{"1 bytes follow the last vertex that the header claims: left out"});
    refuses("a.ply", header + body.substr(0, body.size() - 1), "the file ends at byte");
  }
}

TEST(PlyReader, PolygonsBecomeFansThatNameTheirFace) {
  const Mesh m = mesh(ascii(kVertex + kFace, kSquare + "4 0 1 2 3\n3 0 1 2\n"));
  EXPECT_EQ(m.faces, (std::vector<std::array<std::int32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
  EXPECT_EQ(m.face_source, (std::vector<std::int32_t>{0, 0, 1}));
  EXPECT_EQ(m.face_line, (std::vector<Index>{14, 14, 15}));
}

TEST(PlyReader, PointsWithoutFaces) {
  const PointTable t = content<PointTable>(
      read("a.ply",
           ascii("element vertex 2\nproperty float z\nproperty float x\nproperty float y\nproperty float u\n"
                 "property float v\nproperty float weight\nelement face 0\n"
                 "property list uchar int vertex_indices\n",
                 "3 1 2 0.5 0.25 2\n6 4 5 0 1 1\n")));
  EXPECT_EQ(t.x, (std::vector<double>{1, 4}));
  EXPECT_EQ(t.z, (std::vector<double>{3, 6}));
  EXPECT_EQ(t.u, (std::vector<double>{0.5, 0}));
  EXPECT_EQ(t.v, (std::vector<double>{0.25, 1}));
  EXPECT_EQ(t.weight, (std::vector<double>{2, 1}));
  EXPECT_EQ(t.line, (std::vector<Index>{13, 14}));
}

TEST(PlyReader, NormalsOfPoints) {
  const PointTable t = content<PointTable>(
      read("a.ply",
           ascii("element vertex 2\nproperty float nx\nproperty float x\nproperty float y\nproperty float z\n"
                 "property float ny\nproperty float nz\n",
                 "0 1 2 3 0.6 0.8\nnan 4 5 6 nan nan\n")));
  EXPECT_EQ(t.x, (std::vector<double>{1, 4}));
  EXPECT_EQ(t.ny, (std::vector<double>{0.6, 0}));
  EXPECT_EQ(t.nz, (std::vector<double>{0.8, 0}));
}

TEST(PlyReader, TellsWhatThePropertiesOfPointsWereTakenFor) {
  const auto told = [](std::initializer_list<const char*> names) {
    std::string header = "element vertex 1\n", row;
    for (const char* name : names) header += std::string("property float ") + name + "\n", row += "1 ";
    const SourceData data = read("a.ply", ascii(header, row + "\n"));
    EXPECT_EQ(data.columns_from, "header");
    return data.columns;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(told({"x", "y", "z"}), (Names{"x", "y", "z"}));
  EXPECT_EQ(told({"red", "z", "x", "y", "quality", "intensity", "alpha"}),
            (Names{"r", "z", "x", "y", "-", "intensity", "a"}));
  EXPECT_EQ(told({"x", "y", "z", "s", "t", "weight", "nx", "ny", "nz"}),
            (Names{"x", "y", "z", "u", "v", "w", "nx", "ny", "nz"}));
  // What lacks its companions is left out.
  EXPECT_EQ(told({"x", "y", "z", "nx", "ny", "t"}), (Names{"x", "y", "z", "-", "-", "time"}));
  EXPECT_TRUE(read("a.ply", ascii("element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                                  "element face 1\nproperty list uchar int vertex_indices\n",
                                  "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"))
                  .columns.empty());  // of a mesh they are no columns
}

TEST(PlyReader, ParametersOfCornersWhereTheyAgree) {
  const std::string header = kVertex + kFace + "property list uchar float texcoord\n";
  const Mesh m = mesh(ascii(header, kSquare + "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 1 1 0 1\n"));
  EXPECT_EQ(m.uv, (std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1}));
  EXPECT_TRUE(mesh(ascii(header, kSquare + "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0.5 1 1 0 1\n")).uv.empty());
}

TEST(PlyReader, NamesWhatIsWrongWithAHeader) {
  const auto bad = [](const std::string& header, const std::string& words) {
    refuses("a.ply", header, words);
  };
  bad("plx\n", "is not a PLY file");
  bad("\x89PNG\r\n", "but like a PNG image");
  bad("ply\nformat ascii 1.0\n", "no end_header line");
  bad("ply\nend_header\n", "no format line");
  bad("ply\nformat ebcdic 1.0\n", ":2: format \"ebcdic\" is none of");
  bad("ply\nformat ascii 2.0\n", ":2: version \"2.0\"");
  bad("ply\nformat ascii 1.0\nelement vertex -4\n", ":3: the count of element \"vertex\" is \"-4\"");
  bad("ply\nformat ascii 1.0\nproperty int x\n", ":3: a property before the first element");
  bad("ply\nformat ascii 1.0\nelement vertex 1\nproperty complex x\n", ":4: \"complex\" is no type");
  bad("ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\n", "no integer");
  bad("ply\nformat ascii 1.0\nelement vertex 1\nelement vertex 1\n", ":4: a second element");
  bad("ply\nformat ascii 1.0\nsurprise\n", ":3: \"surprise\" is no word");
  bad(ascii("", ""), "no element \"vertex\"");
  bad(ascii("element vertex 1\nproperty int x\nproperty int y\n", "1 2\n"), "no property z");
  bad(ascii("element vertex 0\nproperty int x\nproperty int y\nproperty int z\n", ""), "0 vertices");
  bad(ascii(kVertex + "element face 1\nproperty list uchar int corners\n", kSquare + "3 0 1 2\n"),
      "no list property vertex_indices");
  bad(ascii(kVertex + "element tristrips 1\nproperty list int int vertex_indices\n", kSquare + "3 0 1 2\n"),
      "triangle strips");
}

TEST(PlyReader, NamesTheLineOfABadNumber) {
  const auto bad = [](const std::string& body, const std::string& words) {
    refuses("a.ply", ascii(kVertex + kFace, body), words);
  };
  bad("0 0 0\n1 0 x\n1 1 0\n0 1 0\n" + kTwo, ":11: vertex 1 (counted from 0): \"x\" is not a number");
  bad("0 0 0\n1 0 nan\n1 1 0\n0 1 0\n" + kTwo, ":11: vertex 1 (counted from 0): z is not finite");
  bad("0 0 0\n1 0\n1 1 0\n0 1 0\n" + kTwo, ":11: vertex 1 (counted from 0): the line has too few numbers");
  bad("0 0 0\n1 0 0 4\n1 1 0\n0 1 0\n" + kTwo, ":11: vertex 1 (counted from 0): the line has more numbers");
  bad("0 0 0\n1 0 1e999\n1 1 0\n0 1 0\n" + kTwo, "beyond the range of a double");
  bad(kSquare + "3 0 1 2\n3 0 1 4\n",
      ":15: face 1 (counted from 0) names vertex 4, but there are 4 vertices, 0 to 3");
  bad(kSquare + "3 0 1 2\n3 0 1 -1\n", "names vertex -1");
  bad(kSquare + "3 0 1 2\n3 0 1 1.5\n", "names vertex 1.5");
  bad(kSquare + "3 0 1 2\n2 0 1\n", ":15: face 1 (counted from 0) has 2 corners; a face has three or more");
  bad(kSquare + "3 0 1 2\n9 0 1 2\n", "too few numbers");
  bad(kSquare + "3 0 1 2\n", "the file ends before face 1 (counted from 0) of the 2");
}

TEST(PlyReader, CountsAreHeldAgainstTheSize) {
  refuses("a.ply",
          ascii("element vertex 1000000000000\nproperty int x\nproperty int y\nproperty int z\n", "0 0 0\n"),
          "claims 1000000000000 vertices, which take 6000000000000 bytes at least, but only 6 bytes follow");
  const std::string big =
      "ply\nformat binary_little_endian 1.0\nelement vertex 9223372036854775807\n"
      "property int x\nproperty int y\nproperty int z\nend_header\n";
  refuses("a.ply", big, "claims 9223372036854775807 vertices of 12 bytes, but only 0 bytes follow");
  // A list that claims more than the file has.
  std::string list =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\n"
      "property uchar z\nelement face 1\nproperty list uint uchar vertex_indices\nend_header\n";
  list += std::string(3, '\0') + "\xFF\xFF\xFF\xFF";
  refuses("a.ply", list, "inside face 0 (counted from 0) (its list claims 4294967295 numbers)");
}

}  // namespace
}  // namespace knotfit::test
