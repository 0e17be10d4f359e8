#include "support.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

const std::string kHeader = "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 5\nNODATA_value -9999\n";

Raster raster(std::string_view text, const ReadOptions& options = {}) {
  return content<Raster>(read("grid.asc", text, options));
}

TEST(EsriAscii, TheFirstRowIsTheNorth) {
  const Raster r = raster(kHeader + "1 2 3\n4 5 6\n");
  EXPECT_EQ(r.columns, 3);
  EXPECT_EQ(r.rows, 2);
  EXPECT_EQ(r.z, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(r.x(0), 12.5);
  EXPECT_EQ(r.y(0), 27.5);
  EXPECT_EQ(r.y(1), 22.5);
}

TEST(EsriAscii, KeywordsInAnyCaseAndOrder) {
  const Raster r = raster(
      "NODATA_VALUE 999\r\nYLLCENTER 0.5\r\nNRows\t2\r\nncols 3\r\nDY 2\r\ndx 1\r\nXllCenter 7\r\n"
      "1 2 3\r\n4 999 6\r\n");
  EXPECT_EQ(r.dx, 1);
  EXPECT_EQ(r.dy, 2);
  EXPECT_EQ(r.x0, 6.5);
  EXPECT_EQ(r.y0, -0.5);
  EXPECT_EQ(r.nodata, 999);
  expect_same(r.z, {1, 2, 3, 4, kNan, 6});
}

TEST(EsriAscii, HolesAreTheNodataValueOrNan) {
  expect_same(raster(kHeader + "1 -9999 3\n-9999.0 nan -9.999e3\n").z, {1, kNan, 3, kNan, kNan, kNan});
  ReadOptions options;
  options.nodata = 3;
  const Raster r = raster(kHeader + "1 -9999 3\n4 5 6\n", options);  // in place of the header's
  expect_same(r.z, {1, -9999, kNan, 4, 5, 6});
  EXPECT_EQ(r.nodata, 3);
  const std::string no_key = kHeader.substr(0, kHeader.find("NODATA"));
  expect_same(raster(no_key + "1 -9999 3\n4 5 6\n").z, {1, kNan, 3, 4, 5, 6});
  // A single-precision value written with fewer digits than it has.
  expect_same(raster(no_key + "nodata_value -3.402823e+38\n1 -3.4028234663852886e+38 3\n4 5 6\n").z,
              {1, kNan, 3, 4, 5, 6});
  expect_same(raster(no_key + "nodata_value nan\n1 -9999 nan\n4 5 6\n").z, {1, -9999, kNan, 4, 5, 6});
}

TEST(EsriAscii, HolesMayBeWords) {
  const std::string no_key = kHeader.substr(0, kHeader.find("NODATA"));
  for (const char* word : {"null",    "NULL",    "nan",     "NaN",  "NA", "n/a",   "#N/A", "none",
                           "NoData",  "no_data", "missing", "void", "*",  "-",     "?",    "1.#QNAN",
                           "-1.#IND", "<NA>",    "\"NA\"",  "nil",  "nd", "1.#NAN"}) {
    SCOPED_TRACE(word);
    const std::string cells = std::string(word) + " 2 3\n4 " + word + " " + word + "\n";
    const std::vector<double> wanted = {kNan, 2, 3, 4, kNan, kNan};
    expect_same(raster(no_key + "NODATA_value " + word + "\n" + cells).z, wanted);
    expect_same(raster(kHeader + cells).z, wanted);  // whatever the header says
    expect_same(raster(no_key + cells).z, wanted);
  }
  // The keyword itself, as a height: where it was there already, or more follows than one value.
  expect_same(raster(no_key + "NODATA_value NODATA\nNODATA 2 3\n4 5 6\n").z, {kNan, 2, 3, 4, 5, 6});
  expect_same(raster(no_key + "nodata 2 3\n4 5 6\n").z, {kNan, 2, 3, 4, 5, 6});
  EXPECT_EQ(raster(no_key + "nodata 2\n1 2 3\n4 5 6\n").nodata, 2);
  // Any other word is one where the header says so, in any case.
  const Raster r = raster(no_key + "nodata_value Leer\nLEER 2 leer\n4 -9999 6\n");
  expect_same(r.z, {kNan, 2, kNan, 4, -9999, 6});
  EXPECT_EQ(r.nodata, -9999);  // of what is written
  refuses("g.asc", no_key + "nodata_value Leer\n1 2 3\n4 voll 6\n",
          "g.asc:8: grid row 2, number 2 of the line: \"voll\" is not a number");
  refuses("g.asc", kHeader + "leer 2 3\n4 5 6\n",
          "g.asc:7: \"leer\" is neither a number nor a header keyword");
  refuses("g.asc", kHeader + "1 2 3\nleer 5 6\n", "\"NODATA_value WORD\" in the header");
  // Before the header has told the size, a word is no height.
  refuses("g.asc", "null 1 2\n" + kHeader, "g.asc:1: not an ESRI grid");
}

TEST(EsriAscii, CountsMayBeWrittenAsFloatingPointNumbers) {
  for (const char* header : {"ncols 3.0\nnrows 2.0\n", "ncols 3.\nnrows 2.000000\n",
                             "ncols 3e0\nnrows 0.2E1\n", "ncols +3\nnrows 20e-1\n"}) {
    SCOPED_TRACE(header);
    const Raster r = raster(std::string(header) + "xllcorner 10\nyllcorner 20\ncellsize 5\n1 2 3\n4 5 6\n");
    EXPECT_EQ(r.columns, 3);
    EXPECT_EQ(r.rows, 2);
    EXPECT_EQ(r.z, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  }
  for (const char* count : {"2.5", "-3.0", "0.0", "1e300", "nan", "inf"})
    refuses("g.asc", std::string("ncols ") + count + "\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n",
            "not a whole number above 0");
}

TEST(EsriAscii, ATextOfPointsIsToldHowItIsRead) {
  for (const char* text : {"8.05 0.99 0.38 181 58 90\n", "//X Y Z R G B\n1 2 3 4 5 6\n", "x y z\n1 2 3\n",
                           "3\n1 2 3\n4 5 6\n7 8 9\n"})
    refuses("cloud.asc", text, "`format = csv`");
}

TEST(EsriAscii, RowsMayBeWrappedOverLines) {
  const std::vector<double> z = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(raster(kHeader + "1 2 3 4 5 6\n").z, z);
  EXPECT_EQ(raster(kHeader + "1\n2\n3\n4\n5\n6\n").z, z);
  EXPECT_EQ(raster(kHeader + " 1 2\n 3\n\n 4 5\n 6").z, z);
}

TEST(EsriAscii, NamesLineAndRowOfAWrongCount) {
  refuses("g.asc", kHeader + "1 2 3\n4 5\n", "g.asc:8: grid row 2 has 2 numbers, but ncols is 3");
  refuses("g.asc", kHeader + "1 2 3 4\n4 5 6\n", "g.asc:7: grid row 1 has 4 numbers, but ncols is 3");
  // As many numbers as the grid has and a line a row: still not the rows of the header.
  refuses("g.asc", kHeader + "1 2\n3 4 5 6\n", "g.asc:7: grid row 1 has 2 numbers, but ncols is 3");
  refuses("g.asc", kHeader + "1 2 3\n4 5 6\n7 8 9\n", "g.asc:9: more numbers than the 2 rows of 3");
  refuses("g.asc", kHeader + "1.000 2.000 3.000\n", "ends after 1 rows, but nrows is 2");
  refuses("g.asc", kHeader, "claims 3 x 2 numbers, but only 0 bytes follow");
}

TEST(EsriAscii, NamesTheLineOfABadNumber) {
  refuses("g.asc", kHeader + "1 2 3\n4 5x 6\n",
          "g.asc:8: grid row 2, number 2 of the line: \"5x\" is not a number");
  refuses("g.asc", kHeader + "1 2 inf\n4 5 6\n",
          "g.asc:7: grid row 1, number 3 of the line: a height is infinite");
  refuses("g.asc", kHeader + "1 2 1e999\n4 5 6\n", "beyond the range of a double");
}

TEST(EsriAscii, RefusesBadHeadersByLine) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = kHeader + "1 2 3\n4 5 6\n";
    return text.replace(text.find(from), from.size(), to);
  };
  refuses("g.asc", with("ncols 3\n", ""), "the header has no ncols");
  refuses("g.asc", with("nrows 2\n", ""), "the header has no nrows");
  refuses("g.asc", with("xllcorner 10\n", ""), "neither xllcorner nor xllcenter");
  refuses("g.asc", with("yllcorner 20\n", "yllcorner 20\nyllcenter 5\n"),
          "g.asc:5: the header has both yllcorner");
  refuses("g.asc", with("cellsize 5\n", ""), "neither cellsize nor dx and dy");
  refuses("g.asc", with("cellsize 5\n", "dx 5\n"), "neither cellsize nor dx and dy");
  refuses("g.asc", with("cellsize 5\n", "cellsize 5\ndx 1\n"), "both cellsize and dx or dy");
  refuses("g.asc", with("cellsize 5", "cellsize -5"), "g.asc:5: cellsize is -5: it must be above 0");
  refuses("g.asc", with("cellsize 5", "cellsize nan"), "g.asc:5: cellsize is \"nan\", not a finite number");
  refuses("g.asc", with("ncols 3", "ncols 0"), "g.asc:1: ncols is \"0\", not a whole number above 0");
  refuses("g.asc", with("ncols 3", "ncols 2.5"), "g.asc:1: ncols is \"2.5\"");
  refuses("g.asc", with("ncols 3", "ncols"), "g.asc:1: ncols has no value");
  refuses("g.asc", with("nrows 2", "ncols 2"), "g.asc:2: ncols is there twice (first on line 1)");
  refuses("g.asc", with("nrows 2", "rows 2"), "g.asc:2: \"rows\" is neither a number nor a header keyword");
  refuses("g.asc", "hello there\n", "g.asc:1: not an ESRI grid: it begins with \"hello\"");
  refuses("g.asc", "1 2 3\n", "`format = csv`");
  refuses("g.grd", "DSAA\n3 2\n", "Surfer grid");
  refuses("g.grd", std::string("CDF\x01\0\0", 6), "netCDF grid");
}

TEST(EsriAscii, ChecksTheClaimBeforeItTakesMemory) {
  refuses("g.asc", "ncols 4000000000\nnrows 4000000000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n",
          "claims 4000000000 x 4000000000 numbers, but only 6 bytes follow");
  refuses("g.asc", "ncols 9223372036854775807\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n",
          "bytes follow");
}

std::string written(const Raster& r) {
  std::ostringstream out;
  write_raster(out, r);
  return out.str();
}

TEST(EsriAscii, ReadsBackExactlyWhatItWrites) {
  Random random;
  for (int k = 0; k < 50; ++k) {
    Raster r;
    r.columns = random.integer(1, 7);
    r.rows = random.integer(1, 7);
    r.x0 = random.uniform(-1e6, 1e6);
    r.y0 = random.uniform(-1e6, 1e6);
    r.dx = random.log_uniform(1e-4, 1e3);
    r.dy = random.integer(0, 1) == 0 ? r.dx : random.log_uniform(1e-4, 1e3);
    for (Index i = 0; i < r.columns * r.rows; ++i)
      r.z.push_back(random.integer(0, 4) == 0 ? kNan : random.uniform(-5000, 5000));
    const Raster back = raster(written(r));
    EXPECT_EQ(back.columns, r.columns);
    EXPECT_EQ(back.rows, r.rows);
    EXPECT_EQ(back.x0, r.x0);
    EXPECT_EQ(back.y0, r.y0);
    EXPECT_EQ(back.dx, r.dx);
    EXPECT_EQ(back.dy, r.dy);
    EXPECT_EQ(back.nodata, r.nodata);
    expect_same(back.z, r.z);
  }
}

TEST(EsriAscii, AHeightEqualToNodataStaysAHeight) {
  Raster r{.columns = 2, .rows = 1, .nodata = 0, .z = {0, kNan}};
  EXPECT_NE(written(r).find("NODATA_value -9999\n0 -9999\n"), std::string::npos) << written(r);
  r.z = {0, -9999};
  expect_same(raster(written(r)).z, r.z);
}

TEST(EsriAscii, RefusesToWriteWhatIsNoRaster) {
  Raster r{.columns = 2, .rows = 2, .z = {1, 2, 3}};
  expect_throw<InvalidInput>([&] { written(r); }, "2 x 2 cells has 3 heights");
  r.z.push_back(kInf);
  expect_throw<InvalidInput>([&] { written(r); }, "height 3 of the raster is infinite");
  r.z.back() = 4;
  r.dx = 0;
  expect_throw<InvalidInput>([&] { written(r); }, "cells of 0 x 1");
}

}  // namespace
}  // namespace knotfit::test
