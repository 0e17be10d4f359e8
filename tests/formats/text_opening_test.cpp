// What stands before the points of a text, and blocks of points.
#include <algorithm>

#include "text_curves.h"
namespace knotfit::test {
namespace {

using Doubles = std::vector<double>;
using Lines = std::vector<Index>;
using Words = std::vector<std::string>;

TEST(LeadingLines, TitlesAboveAHeaderAndUnitsUnderIt) {
  const SourceData data =
      read("a.csv", "Export of scan 7\nmade 2024-05-01\n\nx,y,z,name\nm,m,m,-\n1,2,3,a\n4,5,6,b\n");
  const PointTable t = content<PointTable>(data);
  EXPECT_EQ(t.z, (Doubles{3, 6}));
  EXPECT_EQ(t.line, (Lines{6, 7}));
  EXPECT_EQ(data.columns, (Words{"x", "y", "z", "-"}));
  EXPECT_EQ(data.columns_from, "header");
  expect_note(data, "line 1 left out, a title: \"Export of scan 7\"");
  expect_note(data, "line 2 left out, a title");
  expect_note(data, "line 5 left out, a line of words under the header");
}

TEST(LeadingLines, CountsOfPoints) {
  const SourceData pts = read("a.pts", "2\n1 2 3 -1000 181 58 90\n4 5 6 -900 10 20 30\n");
  EXPECT_EQ(content<PointTable>(pts).z, (Doubles{3, 6}));
  EXPECT_EQ(pts.columns, (Words{"x", "y", "z", "intensity", "r", "g", "b"}));
  EXPECT_EQ(pts.columns_from, "guess");
  expect_note(pts, "line 1 left out, the number of points: \"2\"");
  const SourceData wrong = read("a.xyz", "300\n1 2 3\n4 5 6\n");
  expect_note(wrong, "a number alone, but 2 points follow: \"300\"");
  EXPECT_EQ(content<PointTable>(wrong).size(), 2);
  const SourceData grid = read("a.xyz", "2 3\n0 0 1\n1 0 2\n2 0 3\n0 1 4\n1 1 5\n2 1 6\n");
  EXPECT_EQ(content<PointTable>(grid).z, (Doubles{1, 2, 3, 4, 5, 6}));
  expect_note(grid, "the numbers of rows and columns: \"2 3\"");
  // Two numbers that count nothing are no header.
  refuses("a.xyz", "2 4\n0 0 1\n1 0 2\n2 0 3\n", "a.xyz:1: 2 columns and no header line");
  refuses("a.xyz", "2 4\n0 0 1\n1 0 2\n2 0 3\n", "if line 1 is no point, leave it out with `skip_lines = 1`");
}

TEST(LeadingLines, CloudCompareNamesItsColumnsInAComment) {
  const SourceData data =
      read("a.asc.txt", "//X Y Z R G B Nx Ny Nz\n2\n1 2 3 0 0 0 0 0 1\n4 5 6 9 9 9 0 1 0\n");
  const PointTable t = content<PointTable>(data);
  EXPECT_EQ(t.x, (Doubles{1, 4}));
  EXPECT_EQ(t.ny, (Doubles{0, 1}));
  EXPECT_EQ(data.columns, (Words{"x", "y", "z", "r", "g", "b", "nx", "ny", "nz"}));
  EXPECT_EQ(data.columns_from, "header");
  const SourceData colours = read("a.xyz", "//X Y Z R G B\n1 2 3 0.5 0.2 0.9\n4 5 6 0.1 0.2 0.3\n");
  EXPECT_TRUE(content<PointTable>(colours).u.empty());
  EXPECT_EQ(colours.columns, (Words{"x", "y", "z", "r", "g", "b"}));
}

TEST(LeadingLines, WhatIsNotCertainIsRefusedWithTheWayOut) {
  // Words as many as columns: a title, or names that nobody knows.
  refuses("a.xyz", "wing root section\n1 2 3\n4 5 6\n7 8 9\n", "leave the line out with `skip_lines = 1`");
  refuses("a.csv", "lon,lat,height\n1,2,3\n4,5,6\n", "name the columns with `columns`");
  // A slip in the first point is no title.
  refuses("a.csv", "1.2.3,4,5\n1,2,3\n4,5,6\n", "a.csv:1: column 1 (x): \"1.2.3\" is not a number");
  refuses("a.csv", "1.2.3,4\n1,2,3\n4,5,6\n", "a.csv:1");
  refuses("a.xyz", "1 2 3 by hand\n1 2 3\n4 5 6\n",
          "if line 1 is no point, leave it out with `skip_lines = 1`");
  refuses("a.csv", "x,y,z\nP1,1,2\n1,2,3\n4,5,6\n", "a.csv:2: column 1 (x): \"P1\" is not a number");
}

TEST(LeadingLines, SkipLinesLeavesOutTheRest) {
  ReadOptions options;
  options.skip_lines = 2;
  const SourceData data = read("a.xyz", "wing root section\n9 9 9\n1 2 3\n4 5 6\n", options);
  EXPECT_EQ(content<PointTable>(data).x, (Doubles{1, 4}));
  EXPECT_EQ(content<PointTable>(data).line, (Lines{3, 4}));
  options.skip_lines = 4;
  refuses("a.xyz", "1 2 3\n4 5 6\n", "4 lines are to be skipped, but there are 2", options);
}

TEST(LeadingLines, NamedColumnsKeepThem) {
  ReadOptions options;
  options.columns = {"y", "x", "z"};
  const SourceData data = read("a.xyz", "Scan 12\n2\n1 2 3\n4 5 6\n", options);
  EXPECT_EQ(content<PointTable>(data).x, (Doubles{2, 5}));
  EXPECT_EQ(data.columns_from, "option");
  expect_note(data, "a title: \"Scan 12\"");
  expect_note(data, "the number of points");
}

TEST(Blocks, OfACurveAreNeverJoinedUnasked) {
  const char* text = "1 2\n3 4\n\n5 6\n7 8\n9 10\n";
  for (const char* name : {"a.dat", "a.csv", "a.xyz"}) {
    expect_throw<FileError>([&] { curve(text, name); }, "2 blocks of points (2 from line 1, 3 from line 4)");
    expect_throw<FileError>([&] { curve(text, name); }, "`block = N`");
    EXPECT_EQ(content<PointTable>(curve(text, name, 1)).x, (Doubles{1, 3}));
    const SourceData second = curve(text, name, 2);
    EXPECT_EQ(content<PointTable>(second).y, (Doubles{6, 8, 10}));
    EXPECT_EQ(content<PointTable>(second).line, (Lines{4, 5, 6}));
    expect_note(second, "block 2 of 2");
    expect_throw<FileError>([&] { curve(text, name, 3); }, "block 3 is asked for, but there are 2");
  }
  // Three columns, too, and of a file of rows.
  const char* space = "1 2 3\n4 5 6\n\n\n7 8 9\n10 11 12\n";
  expect_throw<FileError>([&] { curve(space); }, "2 blocks");
  EXPECT_EQ(content<PointTable>(curve(space, "a.txt", 2)).z, (Doubles{9, 12}));
  EXPECT_EQ(content<PointRows>(curve(space, "a.rows", 2)).rows(), 1);
  // What is wrong in another block is not the concern of the one asked for.
  EXPECT_EQ(content<PointTable>(curve("1 2\n3 nan\n\n5 6\n7 8\n", "a.dat", 2)).x, (Doubles{5, 7}));
  EXPECT_EQ(content<PointTable>(curve("1 2\n3 4\n\n", "a.dat", 1)).x, (Doubles{1, 3}));
}

TEST(Blocks, NamesAndCountsPartThemToo) {
  for (const char* mark : {"lower surface", "3", "> segment 2", "# a comment alone does not\nlower"}) {
    SCOPED_TRACE(mark);
    const std::string text = std::string("upper\n0 0\n1 1\n2 0\n") + mark + "\n0 0\n1 -1\n2 0\n";
    expect_throw<FileError>([&] { curve(text); }, "2 blocks of points (3 from line 2, 3 from line");
    EXPECT_EQ(content<PointTable>(curve(text, "a.dat", 2)).y, (Doubles{0, -1, 0}));
  }
  // A line with numbers in it is a fault, and of a surface any is.
  expect_throw<FileError>([&] { curve("0 0\n1 x1\n2 0\n"); }, "a.dat:2: column 2 (y)");
  refuses("a.xyz", "0 0 1\n1 1 1\nlower surface\n2 0 1\n", "a.xyz:3: 2 columns");
}

}  // namespace
}  // namespace knotfit::test
