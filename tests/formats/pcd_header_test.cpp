#include "formats/pcd_header.h"

#include <gtest/gtest.h>

#include <string>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

PcdHeader header(const std::string& text) {
  return parse_pcd_header(FileBytes("a.pcd", text));
}

const std::string kFields =
    "VERSION .7\nFIELDS x y z _ rgb\nSIZE 8 4 4 1 4\nTYPE F F F U U\nCOUNT 1 1 1 3 1\n";

TEST(PcdHeader, SaysFieldsSizeAndEncoding) {
  const std::string text = kFields + "WIDTH 4\nHEIGHT 2\nPOINTS 8\nDATA binary_compressed\n";
  const PcdHeader h = header(text + "xyz");
  ASSERT_EQ(h.fields.size(), 5u);
  EXPECT_EQ(h.fields[3].name, "_");
  EXPECT_EQ(h.fields[3].bytes(), 3);
  EXPECT_EQ(h.point_bytes(), 8 + 4 + 4 + 3 + 4);
  EXPECT_EQ(h.width, 4);
  EXPECT_EQ(h.height, 2);
  EXPECT_EQ(h.points, 8);
  EXPECT_EQ(h.encoding, PcdEncoding::compressed);
  EXPECT_EQ(h.offset, text.size());
  EXPECT_EQ(h.lines, 9);
}

TEST(PcdHeader, NamesTheLineOfFieldsThatDoNotAgree) {
  const auto bad = [](const std::string& text, const std::string& words) {
    test::expect_throw<FileError>([&] { header(text); }, words);
  };
  bad("FIELDS x y z\nSIZE 4 4\n", "a.pcd:2: SIZE has 2 values, but there are 3 fields");
  bad("FIELDS x\nTYPE C\n", "a.pcd:2: TYPE \"C\": there are F, I and U");
  bad("FIELDS x\nFIELDS y\n", "a second list of fields");
  bad("FIELDS x\nCOLOUR red\n", "\"COLOUR\" is no word of a PCD header");
  bad(kFields + "WIDTH 4\nHEIGHT 2\nPOINTS 9\nDATA ascii\n", "POINTS is 9, but WIDTH x HEIGHT are 4 x 2");
  bad(kFields + "WIDTH 0\nHEIGHT 1\nPOINTS 0\nDATA ascii\n", "the header claims 0 points");
  bad(kFields + "WIDTH 1\nHEIGHT 1\nDATA zip\n",
      "DATA \"zip\": there are ascii, binary and binary_compressed");
  bad("WIDTH 1\nHEIGHT 1\nDATA ascii\n", "the header names no FIELDS");
  bad(kFields, "before DATA: it is cut off");
}

}  // namespace
}  // namespace knotfit
