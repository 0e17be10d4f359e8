// Every bad_* file of these formats against what its README says is wrong with it.
#include "support.h"
namespace knotfit::test {
namespace {

void refuses_file(const std::string& name, const std::string& words) {
  SCOPED_TRACE(name);
  const std::string path = test_data("bad/" + name).string();
  expect_throw<FileError>([&] { read_data(path); }, words);
  expect_throw<FileError>([&] { read_data(path); }, path + ":");
}

SourceData reads(const std::string& name) {
  return read_data(test_data("bad/" + name).string());
}

TEST(BadFiles, TablesNameLineAndColumn) {
  refuses_file("bad_nan.csv", ":18: column 3 (z): \"nan\" is not a finite number");
  refuses_file("bad_columns.csv", ":25: 4 columns, but the header names 5");
  refuses_file("bad_number.csv", ":11: column 2 (y): \"1.2.3\" is not a number");
  refuses_file("bad_empty.csv", ": the file is empty");
  refuses_file("bad_header_only.csv", "no data line after the header (line 1)");
}

TEST(BadFiles, ArraysNameShapeAndType) {
  refuses_file("bad_huge_header.npy",
               "claims 1000000000000 x 3 numbers of 8 bytes, but only 240 bytes follow");
  refuses_file("bad_object.npy", "Python objects, which are never unpickled");
  refuses_file("bad_shape.npy",
               "shape 4 x 5 x 7 is neither n x 3 to n x 9 points, nor H x W heights, nor H x W x 3");
}

TEST(BadFiles, GridsNameLineAndRow) {
  refuses_file("bad_short_row.asc", ":10: grid row 4 has 7 numbers, but ncols is 8");
  refuses_file("bad_no_ncols.asc", "the header has no ncols");
  refuses_file("bad_cellsize.asc", ":5: cellsize is 0: it must be above 0");
}

TEST(BadFiles, RowsNameTheLine) {
  refuses_file("bad_rows.txt", ":18: column 3 (z): \"abc\" is not a number");
}

// These are sound files; what is wrong shows itself when parameters or a fit are asked for.
TEST(BadFiles, WhatIsWrongOnlyLaterReads) {
  EXPECT_EQ(content<PointTable>(reads("bad_collinear.csv")).size(), 50);
  EXPECT_EQ(content<PointTable>(reads("bad_few_points.csv")).size(), 5);
  EXPECT_EQ(content<PointTable>(reads("bad_outside_uv.csv")).u[12], 1.2);
  EXPECT_EQ(content<PointTable>(reads("bad_outside_uv.csv")).line[12], 14);
  const PointTable duplicates = content<PointTable>(reads("bad_duplicate_uv.csv"));
  for (const std::size_t line : {32U, 57U}) {
    EXPECT_EQ(duplicates.u[line - 2], duplicates.u[5]);
    EXPECT_EQ(duplicates.v[line - 2], duplicates.v[5]);
  }
  for (const double z : content<Raster>(reads("bad_all_nodata.asc")).z) EXPECT_TRUE(std::isnan(z));
}

}  // namespace
}  // namespace knotfit::test
