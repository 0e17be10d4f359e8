#include "support.h"
namespace knotfit::test {
namespace {

using Doubles = std::vector<double>;
using Lines = std::vector<Index>;

void expect_two_points(const PointTable& t) {
  EXPECT_EQ(t.x, (Doubles{1, 4}));
  EXPECT_EQ(t.y, (Doubles{2, 5}));
  EXPECT_EQ(t.z, (Doubles{3, 6}));
}

TEST(CsvReader, EverySeparatorGivesTheSameTable) {
  for (const char* text :
       {"x,y,z\n1,2,3\n4,5,6\n", "x;y;z\n1;2;3\n4;5;6\n", "x\ty\tz\n1\t2\t3\n4\t5\t6",
        "x y z\n 1  2 3 \n4 5 6\n", "x, y, z\n1, 2, 3\n4 ,5 , 6\n", "x,y,z,\n1,2,3,\n4,5,6,\n",
        "1 2 3\n4\t5 6\n", "1,2,3\r\n4,5,6\r\n", "1 2 3\r4 5 6\r", "\xEF\xBB\xBFx,y,z\n1,2,3\n4,5,6\n",
        "\"x\",\"y\",\"z\"\n\"1\",\"2\",\"3\"\n4,5,6\n", "sep=;\nx;y;z\n1;2;3\n4;5;6\n",
        "x y z\n1,2,3\n4,5,6\n", "x\ty\tz\n1 2 3\n4 5 6\n"}) {
    SCOPED_TRACE(text);
    expect_two_points(table(text));
  }
}

TEST(CsvReader, CommentsAndBlankLinesDoNotCountButLinesDo) {
  const PointTable t =
      table("# made by hand\n// twice\n% and thrice\n\nx,y,z\n1,2,3 # first\n,,\n#\n4,5,6 // last\n\n");
  expect_two_points(t);
  EXPECT_EQ(t.line, (Lines{6, 9}));
}

TEST(CsvReader, CountsOfColumnsWithoutAHeader) {
  expect_two_points(table("1 2 3\n4 5 6\n"));
  const PointTable five = table("1,2,3,0.25,0.5\n4,5,6,1,0\n");
  expect_two_points(five);
  EXPECT_EQ(five.u, (Doubles{0.25, 1}));
  EXPECT_EQ(five.v, (Doubles{0.5, 0}));
  EXPECT_TRUE(five.weight.empty());
  EXPECT_EQ(table("1,2,3,0.25,0.5,7\n").weight, (Doubles{7}));
  refuses("a.csv", "1,2\n", "a.csv:1: 2 columns and no header");
  expect_two_points(table("1,2,3,-7\n4,5,6,8\n"));
  refuses("a.csv", "1,2,3,4,5,6,7,8,9,10,11\n", "a.csv:1: 11 columns and no header");
  refuses("a.csv", "1,2,3,4,5,6,7,8,9,10,11\n", "`columns`");
}

TEST(CsvReader, HeaderNamesInAnyOrderCaseAndDress) {
  expect_two_points(table("Z,X,Y\n3,1,2\n6,4,5\n"));
  expect_two_points(table("id,x [mm],y (mm),z,name\n7,1,2,3,a b\n8,4,5,6,\n"));
  const PointTable t = table("s,t,z,weight\n0.1,0.2,3,2\n");
  EXPECT_EQ(t.u, (Doubles{0.1}));
  EXPECT_EQ(t.v, (Doubles{0.2}));
  EXPECT_EQ(t.weight, (Doubles{2}));
  EXPECT_TRUE(t.x.empty());
  EXPECT_EQ(table("u,v,z,W\n0.1,0.2,3,2\n").weight, (Doubles{2}));
}

TEST(CsvReader, NormalsAreAllThereOrNone) {
  const PointTable t = table("x,y,z,nx,normal_y,NZ\n1,2,3,0,0.6,0.8\n4,5,6,nan,0,1\n");
  EXPECT_EQ(t.nx, (Doubles{0, 0}));
  EXPECT_EQ(t.ny, (Doubles{0.6, 0}));
  EXPECT_EQ(t.nz, (Doubles{0.8, 0})) << "one that is not finite is unknown";
  EXPECT_TRUE(table("x,y,z,nx,ny\n1,2,3,0,0.6\n").nx.empty());
  ReadOptions options;
  options.columns = {"x", "y", "z", "nx", "ny", "nz"};
  EXPECT_EQ(table("1 2 3 4 5 6\n7 8 9 0 0 1\n", options).nz, (Doubles{6, 1}));
  options.nodata = 3;
  EXPECT_EQ(table("1 2 3 4 5 6\n7 8 9 0 0 1\n", options).nz, (Doubles{1}));
}

TEST(CsvReader, ACommentRightBeforeTheDataMayBeTheHeader) {
  const PointTable t = table("# a file\n# u v z\n0.1 0.2 3\n", {}, "a.txt");
  EXPECT_EQ(t.u, (Doubles{0.1}));
  EXPECT_EQ(t.z, (Doubles{3}));
  expect_two_points(table("//X Y Z\n1 2 3\n4 5 6\n"));
  expect_two_points(table("# this is text\n1 2 3\n4 5 6\n"));
  expect_two_points(table("# z only counts\n1 2 3\n4 5 6\n"));
}

TEST(CsvReader, NamedColumnsWinOverHeaderAndCount) {
  ReadOptions options;
  options.columns = {"-", "z", "y", "x"};
  expect_two_points(table("P1 3 2 1\nP2 6 5 4\n", options));
  expect_two_points(table("name,a,b,c\nP1,3,2,1\nP2,6,5,4\n", options));
  refuses("a.csv", "1,2,3\n", "a.csv:1: 3 columns, but 4 are named", options);
  options.columns = {"x", "y", "z", "u", "v", "w"};
  EXPECT_EQ(table("1 2 3 0 1 9\n", options).weight, (Doubles{9}));
  for (const auto& [columns, words] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"x", "y", "q"}, "unknown column \"q\""},
           {{"x", "x", "z"}, "more than once"},
           {{"x", "z"}, "x is there without y"},
           {{"u", "z", "x", "y"}, "u is there without v"},
           {{"x", "y"}, "no column z"},
           {{"z"}, "neither x, y nor u, v"}}) {
    options.columns = columns;
    expect_throw<InvalidInput>([&] { read("a.csv", "1,2,3\n", options); }, words);
  }
}

TEST(CsvReader, PlacesMayLackZ) {
  ReadOptions options;
  options.places = true;
  const PointTable t = table("u,v\n0.1,0.2\n0.3,0.4\n", options);
  EXPECT_EQ(t.size(), 2);
  EXPECT_EQ(t.v, (Doubles{0.2, 0.4}));
  expect_same(t.z, {kNan, kNan});
  EXPECT_EQ(table("x,y,z\n1,2,3\n", options).z, (Doubles{3}));
  refuses("a.csv", "u,v\n0.1,0.2\n", "no column z");
}

TEST(CsvReader, EveryFormOfNumber) {
  const PointTable t = table("+1 2.0D+00 3e0\n4. 5E+0 .6e1\n");
  expect_two_points(t);
  EXPECT_EQ(table("1e-400 0 0\n").x, (Doubles{0}));
}

TEST(CsvReader, NamesTheLineOfAWrongCount) {
  refuses("a.csv", "x,y,z\n1,2,3\n1,2\n", "a.csv:3: 2 columns, but the header names 3");
  refuses("a.csv", "x,y,z\n1,2,3\n1,2,3,4\n", "a.csv:3: 4 columns, but the header names 3");
  refuses("a.csv", "1 2 3\n\n1 2\n", "a.csv:3: 2 columns, but line 1 has 3");
  refuses("a.csv", "1 2 3\n7\n", "a.csv:2: 1 column, but");
  refuses("a.csv", "x,y,z\n1;2;3\n4;5;6;7\n", "a.csv:3: 4 columns");
}

TEST(CsvReader, NamesLineAndColumnOfABadNumber) {
  refuses("a.csv", "x,y,z\n1,2,3\n1,2x,3\n", "a.csv:3: column 2 (y): \"2x\" is not a number");
  refuses("a.csv", "1.2.3,4,5\n", "a.csv:1: column 1 (x): \"1.2.3\" is not a number");
  refuses("a.csv", "x,y,z\n1,,3\n", "a.csv:2: column 2 (y) is empty");
  refuses("a.csv", "x,y,z\n1,2 3,4\n", "a.csv:2: column 2 (y): \"2 3\" is not a number");
  refuses("a.csv", "x,y,z\n1,2,1e999\n", "a.csv:2: column 3 (z): \"1e999\" is beyond the range");
  refuses("a.csv", "x;y;z\n1,5;2;3\n", "write decimal points, not commas");
  refuses("a.csv", "x,y,z\n\"1,000.5\",2,3\n",
          "\"1,000.5\" is not a number (write numbers without commas between");
  refuses("a.csv", "P1 1 2\n", "a.csv:1: column 1 (x): \"P1\" is not a number");
  refuses("a.csv", "P1 1 2 3\n", "a.csv:1: column 1 (x): \"P1\" is not a number");
}

TEST(CsvReader, NamesLineAndColumnOfNanAndInf) {
  refuses("a.csv", "x,y,z\n1,2,3\n1,2,nan\n", "a.csv:3: column 3 (z): \"nan\" is not a finite number");
  refuses("a.csv", "x,y,z\n-inf,2,3\n", "a.csv:2: column 1 (x): \"-inf\" is not a finite number");
  refuses("a.csv", "x,y,z\n1,2,3\n\n\nnan,nan,nan\n", "a.csv:5: column 1 (x)");
  EXPECT_EQ(table("x,y,z,other\n1,2,3,nan\n").size(), 1);  // not read
}

TEST(CsvReader, NodataLeavesPointsOut) {
  ReadOptions options;
  options.nodata = -9999;
  const PointTable t = table("x,y,z,u,v\n1,2,3,0,0\n9,9,-9999,0.5,0.5\n4,5,6,1,1\n", options);
  expect_two_points(t);
  EXPECT_EQ(t.u, (Doubles{0, 1}));
  EXPECT_EQ(t.line, (Lines{2, 4}));
  options.nodata = kNan;
  expect_two_points(table("1 2 3\n7 8 nan\n4 5 6\n", options));
  refuses("a.csv", "1 2 nan\n", "every point has the nodata value", options);
}

TEST(CsvReader, RefusesHeadersThatMakeNoPoints) {
  refuses("a.csv", "x,y\n1,2\n", "a.csv:1: there is no column z in the header \"x\", \"y\"");
  refuses("a.csv", "a,b,c\n1,2,3\n", "there is no column z");
  refuses("a.csv", "x,z\n1,2\n", "x is there without y");
  refuses("a.csv", "u,s,v,z\n1,2,3,4\n", "u is there more than once");
  refuses("a.csv", "z,w\n1,2\n", "neither x, y nor u, v");
  refuses("a.csv", "x,y,z\n", "no data line after the header (line 1)");
  refuses("a.csv", "# nothing\n\n", "there is no line with data");
}

}  // namespace
}  // namespace knotfit::test
