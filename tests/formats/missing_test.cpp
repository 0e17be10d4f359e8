// Missing values: refused with the way out, or left out and counted, in every format alike.
#include "formats/missing.h"

#include "cloud_files.h"
#include "support.h"
namespace knotfit::test {
namespace {

using Doubles = std::vector<double>;

const ReadOptions kAny = {.format = "", .columns = {}, .nodata = kNan, .classes = {}, .returns = {}};

ReadOptions number(double value) {
  ReadOptions options;
  options.nodata = value;
  return options;
}

/// Four points, the second without z: refused by its place, left out by the word and by the number.
void expect_left_out(const std::string& name, const std::string& missing, const std::string& far,
                     const std::string& place, Index line) {
  SCOPED_TRACE(name);
  if (!missing.empty()) {
    refuses(name, missing, place);
    refuses(name, missing, "`nodata = nan` leaves out the points that miss a value");
    const SourceData data = read(name, missing, kAny);
    EXPECT_EQ(content<PointTable>(data).z, (Doubles{3, 9, 12}));
    EXPECT_EQ(data.left_out, 1);
    EXPECT_EQ(data.notes.back(), "1 point left out: a value is missing (`nodata = nan`)");
    EXPECT_EQ(content<PointTable>(data).line[1], line + 1);
  }
  const SourceData data = read(name, far, number(-9999));
  EXPECT_EQ(content<PointTable>(data).z, (Doubles{3, 9, 12}));
  EXPECT_EQ(content<PointTable>(data).line[1], line + 1);
  EXPECT_EQ(data.left_out, 1);
  EXPECT_EQ(data.notes.back(), "1 point left out: the value -9999 stands for none (`nodata`)");
}

std::string text(const std::string& z, const std::string& mark = ",") {
  std::string out = "x,y,z\n1,2,3\n4,5," + z + "\n7,8,9\n10,11,12\n";
  for (std::size_t at = 0; (at = out.find(',', at)) != std::string::npos; at += mark.size())
    out.replace(at, 1, mark);
  return out;
}

TEST(Missing, EveryWordInText) {
  for (const char* word :
       {"nan", "NaN", "-nan", "NA", "n/a", "null", "NULL", "None", "", "-", "\"\"", "#N/A", "1.#QNAN"}) {
    SCOPED_TRACE(word);
    for (const char* mark : {",", ";", "\t"})
      expect_left_out("a.csv", text(word, mark), text("-9999", mark), "a.csv:3: column 3 (z)", 3);
    if (*word != 0) expect_left_out("a.xyz", text(word, " "), text("-9999", " "), "a.xyz:3: column 3 (z)", 3);
  }
  refuses("a.csv", text("inf"), "a.csv:3: column 3 (z): \"inf\" is not a finite number; `nodata = nan`");
  refuses("a.csv", text(""), "a.csv:3: column 3 (z) is empty; `nodata = nan`");
  EXPECT_EQ(read("a.csv", text("inf"), kAny).left_out, 1);
}

TEST(Missing, EmptyCellsAnywhere) {
  refuses("a.csv", "x,y,z\n,2,3\n4,5,6\n", "a.csv:2: column 1 (x) is empty");
  refuses("a.csv", "x\ty\tz\n\t2\t3\n4\t5\t6\n", "a.csv:2: column 1 (x) is empty");
  refuses("a.csv", "1,2,\n4,5,6\n7,8,9\n", "a.csv:1: column 3 (z) is empty");
  EXPECT_EQ(content<PointTable>(read("a.csv", "1,2,\n4,5,6\n,8,9\n7,,1\n1,1,1\n", kAny)).z, (Doubles{6, 1}));
  // A cell that is not used may be empty.
  EXPECT_EQ(content<PointTable>(read("a.csv", "x,y,z,name\n1,2,3,\n4,5,6,b\n")).size(), 2);
  // Fewer cells are no missing value.
  refuses("a.csv", "x,y,z\n1,2,3\n4,5\n", "a.csv:3: 2 columns, but the header names 3");
  // A row without anything is a blank line.
  EXPECT_EQ(content<PointTable>(read("a.csv", "x,y,z\n1,2,3\n,,\n4,5,6\n")).size(), 2);
}

TEST(Missing, ANumberInAnotherColumnWhereItCanBeNoValue) {
  const SourceData data = read("a.xyz", "1 2 3\n-9999 5 6\n7 -9999 9\n8 9 10\n", number(-9999));
  EXPECT_EQ(content<PointTable>(data).z, (Doubles{3, 10}));
  EXPECT_EQ(data.left_out, 2);
  // 0 among the x of the others is a value.
  EXPECT_EQ(content<PointTable>(read("a.xyz", "0 1 1\n1 2 0\n2 3 4\n3 4 5\n", number(0))).x,
            (Doubles{0, 2, 3}));
  EXPECT_EQ(
      content<PointTable>(read("a.csv", "x,y,z,u,v\n1,2,3,.5,.5\n4,5,6,-1e10,1\n7,8,9,1,1\n", number(-1e10)))
          .u,
      (Doubles{0.5, 1}));
}

TEST(Missing, OfACurveY) {
  ReadOptions options = number(-9999);
  options.curve = options.places = true;
  EXPECT_EQ(content<PointTable>(read("a.csv", "x,y\n0,1\n1,-9999\n2,3\n", options)).x, (Doubles{0, 2}));
  options.nodata = kNan;
  const SourceData data = read("a.csv", "x,y\n0,1\n1,\n2,3\nNA,4\n", options);
  EXPECT_EQ(content<PointTable>(data).y, (Doubles{1, 3}));
  EXPECT_EQ(data.left_out, 2);
}

TEST(Missing, RowsKeepHoles) {
  const auto rows = content<PointRows>(read("a.rows", "1 2 3\n4 5 NA\n\n7 8 9\n1 1 1\n", kAny));
  expect_same(rows.xyz, {1, 2, 3, kNan, kNan, kNan, 7, 8, 9, 1, 1, 1});
  refuses("a.rows", "1 2 3\n4 5 NA\n\n7 8 9\n1 1 1\n",
          "a.rows:2: column 3 (z): \"NA\" is not a finite number; `nodata = nan`");
}

TEST(Missing, Ply) {
  const auto ascii = [](const char* z) {
    return std::string(
               "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
               "z\n"
               "end_header\n1 2 3\n4 5 ") +
           z + "\n7 8 9\n10 11 12\n";
  };
  for (const char* word : {"nan", "NA", "null"})
    expect_left_out("a.ply", ascii(word), ascii("-9999"),
                    "a.ply:9: vertex 1 (counted from 0): z is not finite", 9);
  const auto binary = [](double z) {
    return std::string(
               "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
               "property float z\nend_header\n") +
           items<float>({1, 2, 3, 4, 5, z, 7, 8, 9, 10, 11, 12});
  };
  expect_left_out("a.ply", binary(kNan), binary(-9999), "vertex 1 (counted from 0): z is not finite", 2);
}

TEST(Missing, Obj) {
  const auto obj = [](const char* z) {
    return std::string("v 1 2 3\nv 4 5 ") + z + "\nv 7 8 9\nv 10 11 12\n";
  };
  for (const char* word : {"nan", "NA"})
    expect_left_out("a.obj", obj(word), obj("-9999"),
                    "a.obj:2: vertex: \"" + std::string(word) + "\" is not a finite number", 2);
  // Of a mesh no vertex is left out.
  refuses("a.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n", "a.obj:2");
}

TEST(Missing, Npy) {
  const auto array = [](double z) { return doubles("4, 3", {1, 2, 3, 4, 5, z, 7, 8, 9, 10, 11, 12}); };
  expect_left_out("a.npy", array(kNan), array(-9999),
                  "row 2 (from 1), column 3 (z): nan is not a finite number", 2);
}

TEST(Missing, Pcd) {
  const auto pcd = [](const std::string& encoding, const std::string& data) {
    return pcd_header("x y z", "4 4 4", "F F F", "1 1 1", 4, 1, encoding) + data;
  };
  const auto ascii = [&](const char* z) {
    return pcd("ascii", std::string("1 2 3\n4 5 ") + z + "\n7 8 9\n10 11 12\n");
  };
  for (const char* word : {"nan", "null"})
    expect_left_out("a.pcd", ascii(word), ascii("-9999"), "point 2 (from 1): z is not finite", 13);
  const auto binary = [&](double z) {
    return pcd("binary", items<float>({1, 2, 3, 4, 5, z, 7, 8, 9, 10, 11, 12}));
  };
  expect_left_out("a.pcd", binary(kNan), binary(-9999), "point 2 (from 1): z is not finite", 2);
}

TEST(Missing, Las) {
  const auto file = [](std::int32_t z) {
    LasFile f;
    f.points = {{.x = 100, .y = 200, .z = 300},
                {.x = 400, .y = 500, .z = z},
                {.x = 700, .y = 800, .z = 900},
                {.x = 1000, .y = 1100, .z = 1200}};
    return las(f);
  };
  const SourceData data = read("a.las", file(-999900), number(-9999));
  EXPECT_EQ(content<PointTable>(data).z, (Doubles{3, 9, 12}));
  EXPECT_EQ(content<PointTable>(data).line, (std::vector<Index>{1, 3, 4}));
  EXPECT_EQ(data.left_out, 1);
}

TEST(Missing, ARasterKeepsItsOwnNodataBesideTheWord) {
  const char* grid =
      "ncols 3\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n1 -9999 nan\n";
  expect_same(content<Raster>(read("a.asc", grid, kAny)).z, {1, kNan, kNan});
  expect_same(content<Raster>(read("a.npy", doubles("2, 2", {1, kNan, 3, 4}), kAny)).z, {1, kNan, 3, 4});
}

TEST(Missing, NothingLeftIsAnError) {
  for (const char* text : {"1,2,nan\n3,4,nan\n", "x,y,z\n1,2,\n"})
    refuses("a.csv", text, "every point has the nodata value", kAny);
  EXPECT_FALSE(is_missing_word("0"));
  EXPECT_FALSE(is_missing_word("nano"));
  EXPECT_FALSE(is_missing_word("x"));
}

}  // namespace
}  // namespace knotfit::test
