#include "formats/ply_header.h"

#include <gtest/gtest.h>

#include <string>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

PlyHeader header(const std::string& text) {
  return parse_ply_header(FileBytes("a.ply", text));
}

TEST(PlyHeader, ListsElementsAndTheirProperties) {
  const std::string text =
      "ply\nformat binary_big_endian 1.0\ncomment made by hand\nelement vertex 8\nproperty double x\n"
      "property uchar red\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
  const PlyHeader h = header(text + "data");
  EXPECT_EQ(h.encoding, PlyEncoding::big_endian);
  EXPECT_EQ(h.offset, text.size());
  EXPECT_EQ(h.lines, 9);
  ASSERT_EQ(h.elements.size(), 2u);
  EXPECT_EQ(h.elements[0].name, "vertex");
  EXPECT_EQ(h.elements[0].count, 8);
  EXPECT_EQ(h.elements[0].row_bytes(), 8 + 1);
  EXPECT_FALSE(h.elements[0].has_list());
  EXPECT_TRUE(h.elements[1].has_list());
  EXPECT_EQ(h.elements[1].row_bytes(), 1) << "the count alone at least";
  EXPECT_EQ(h.elements[1].properties[0].type.size, 4);
}

TEST(PlyHeader, NamesTheLineOfWhatMakesNoSense) {
  const auto bad = [](const std::string& text, const std::string& words) {
    test::expect_throw<FileError>([&] { header(text); }, words);
  };
  const std::string head = "ply\nformat ascii 1.0\n";
  bad("solid\n", "does not begin with a line \"ply\"");
  bad("ply\nformat text 1.0\nend_header\n", "a.ply:2: format \"text\" is none of ascii");
  bad("ply\nformat ascii 2.0\nend_header\n", "a.ply:2: version \"2.0\" of PLY is not known");
  bad("ply\nend_header\n", "the header has no format line");
  bad(head + "element vertex\n", "a.ply:3: element needs a name and a count");
  bad(head + "element vertex -1\n", "the count of element \"vertex\" is \"-1\"");
  bad(head + "element a 1\nelement a 1\n", "a.ply:4: a second element \"a\"");
  bad(head + "property int x\n", "a property before the first element");
  bad(head + "element a 1\nproperty real x\n", "\"real\" is no type of a property");
  bad(head + "element a 1\nproperty list float int x\n", "the count of list \"x\" is no integer");
  bad(head + "vertices 3\n", "\"vertices\" is no word of a PLY header");
  bad(head + "element a 1\n", "the header has no end_header line");
}

}  // namespace
}  // namespace knotfit
