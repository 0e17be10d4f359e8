#include "support.h"
namespace knotfit::test {
namespace {

using Offsets = std::vector<Index>;

PointRows rows(std::string_view text, const std::string& name = "rows.txt", const ReadOptions& options = {}) {
  return content<PointRows>(read(name, text, options));
}

TEST(RowsReader, ABlankLineEndsARow) {
  const PointRows r = rows("1 2 3\n4 5 6\n\n7 8 9\n10 11 12\n");
  EXPECT_EQ(r.xyz, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(r.row_start, (Offsets{0, 2, 4}));
  EXPECT_EQ(r.line, (Offsets{1, 2, 4, 5}));
  EXPECT_EQ(r.common_length(), 2);
}

TEST(RowsReader, BlankLinesAtTheEndsAndInRunsAreNoRows) {
  for (const char* text : {"\n\n1 2 3\n\n\n4 5 6\n7 8 9\n\n\n", "1 2 3\r\n\r\n4 5 6\r\n7 8 9\r\n",
                           "# c\n1 2 3\n \t \n4 5 6\n# c\n7 8 9\n", "1,2,3\n\n4,5,6\n7,8,9\n"}) {
    SCOPED_TRACE(text);
    EXPECT_EQ(rows(text).row_start, (Offsets{0, 1, 3}));
    EXPECT_EQ(rows(text).common_length(), 0);
  }
}

TEST(RowsReader, OnlyThreeColumnsWithoutHeaderInGroupsAreRows) {
  for (const char* text : {"1 2 3\n4 5 6\n\n", "\n1 2 3\n4 5 6\n", "x y z\n1 2 3\n\n4 5 6\n",
                           "1 2 3 0 0\n\n4 5 6 1 1\n", "# u v z\n1 2 3\n\n4 5 6\n"}) {
    SCOPED_TRACE(text);
    EXPECT_EQ(content<PointTable>(read("a.txt", text)).size(), 2);
  }
  EXPECT_EQ(content<PointTable>(read("a.csv", "1,2,3\n\n4,5,6\n")).size(), 2);
  EXPECT_EQ(rows("# x y z\n1 2 3\n\n4 5 6\n").rows(), 2);
  EXPECT_EQ(rows("1 2 3\n\n4 5 6\n", "a.xyz").rows(), 2);
  EXPECT_EQ(rows("1 2 3\n\n4 5 6\n", "a.DAT").rows(), 2);
}

TEST(RowsReader, CanBeAskedFor) {
  EXPECT_EQ(rows("1 2 3\n4 5 6\n", "a.rows").rows(), 1);
  ReadOptions options;
  options.format = "rows";
  EXPECT_EQ(rows("x,y,z\n1,2,3\n\n4,5,6\n", "a.csv", options).rows(), 2);
  options.columns = {"z", "-", "y", "x"};
  EXPECT_EQ(rows("3 a 2 1\n\n6 b 5 4\n", "a.txt", options).xyz, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  options.columns = {"x", "y", "z", "u", "v"};
  refuses("a.txt", "1 2 3 4 5\n", "columns x, y and z only", options);
  options.columns.clear();
  options.format = "csv";
  EXPECT_EQ(content<PointTable>(read("a.txt", "1 2 3\n\n4 5 6\n", options)).size(), 2);
}

TEST(RowsReader, HolesAreNanOrTheNodataValue) {
  expect_same(rows("1 2 3\nnan nan nan\n\n4 5 6\n7 8 9\n").xyz,
              {1, 2, 3, kNan, kNan, kNan, 4, 5, 6, 7, 8, 9});
  ReadOptions options;
  options.nodata = 0;
  expect_same(rows("1 2 3\n4 5 0\n\n4 5 6\n7 8 9\n", "a.txt", options).xyz,
              {1, 2, 3, kNan, kNan, kNan, 4, 5, 6, 7, 8, 9});
  refuses("a.txt", "1 2 3\n1 2 nan\n\n4 5 6\n", "a.txt:2: column 3 (z): \"nan\" is not a finite number");
  refuses("a.txt", "nan nan nan\n\n4 inf 6\n", "a.txt:3: column 2 (y): \"inf\" is not a finite number");
}

TEST(RowsReader, NamesTheLineOfABadNumber) {
  refuses("a.txt", "1 2 3\n\n4 5 abc\n", "a.txt:3: column 3 (z): \"abc\" is not a number");
  refuses("a.txt", "1 2 3\n\n4 5\n", "a.txt:3: 2 columns, but line 1 has 3");
}

}  // namespace
}  // namespace knotfit::test
