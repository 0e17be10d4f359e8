#include "formats/npy_header.h"
#include "support.h"
namespace knotfit::test {
namespace {

using Doubles = std::vector<double>;

PointTable points(std::string_view bytes, const ReadOptions& options = {}) {
  return content<PointTable>(read("a.npy", bytes, options));
}
Raster heights(std::string_view bytes, const ReadOptions& options = {}) {
  return content<Raster>(read("a.npy", bytes, options));
}

template <class T>
void expect_type(const std::string& type) {
  for (const bool big : {false, true}) {
    const std::string order = sizeof(T) == 1 ? "|" : big ? ">" : "<";
    SCOPED_TRACE(order + type);
    const Raster r = heights(npy(npy_dictionary(order + type, "2, 2"), items<T>({1, 2, 3, 100}, big)));
    EXPECT_EQ(r.z, (Doubles{1, 2, 3, 100}));
  }
}

TEST(Npy, EveryTypeAndByteOrder) {
  expect_type<double>("f8");
  expect_type<float>("f4");
  expect_type<std::int8_t>("i1");
  expect_type<std::int16_t>("i2");
  expect_type<std::int32_t>("i4");
  expect_type<std::int64_t>("i8");
  expect_type<std::uint8_t>("u1");
  expect_type<std::uint16_t>("u2");
  expect_type<std::uint32_t>("u4");
  expect_type<std::uint64_t>("u8");
  const Raster r = heights(npy(npy_dictionary("<i2", "1, 2"), items<std::int16_t>({-5, 7})));
  EXPECT_EQ(r.z, (Doubles{-5, 7}));
}

TEST(Npy, HalfPrecision) {
  // 1, -2, 65504 (largest), 2^-24 (smallest), 0.333251953125, NaN: bits by IEEE 754.
  const std::string data("\x00\x3c\x00\xc0\xff\x7b\x01\x00\x55\x35\x00\x7e", 12);
  expect_same(heights(npy(npy_dictionary("<f2", "3, 2"), data)).z,
              {1, -2, 65504, std::ldexp(1, -24), 0.333251953125, kNan});
}

TEST(Npy, EveryHeaderVersionAndSpelling) {
  const std::string data = items<double>({1, 2, 3, 4});
  for (const int version : {1, 2, 3})
    EXPECT_EQ(heights(npy(npy_dictionary("<f8", "2, 2"), data, version)).z, (Doubles{1, 2, 3, 4}));
  for (const char* header : {"{'shape': (2, 2), 'fortran_order': False, 'descr': '<f8'}",
                             "{\"descr\":\"<f8\",\"fortran_order\":False,\"shape\":(2,2)}",
                             "{'descr': 'f8', 'fortran_order': False, 'shape': (2L, 2L), }",
                             "{'descr': '=f8', 'fortran_order': False, 'shape': (2, 2,), }"})
    EXPECT_EQ(heights(npy(header, data)).z, (Doubles{1, 2, 3, 4})) << header;
}

TEST(Npy, FortranOrderIsTurned) {
  EXPECT_EQ(heights(npy(npy_dictionary("<f8", "2, 4", true), items<double>({1, 5, 2, 6, 3, 7, 4, 8}))).z,
            (Doubles{1, 2, 3, 4, 5, 6, 7, 8}));
  const PointTable t = points(npy(npy_dictionary("<f8", "2, 3", true), items<double>({1, 4, 2, 5, 3, 6})));
  EXPECT_EQ(t.x, (Doubles{1, 4}));
  EXPECT_EQ(t.y, (Doubles{2, 5}));
  EXPECT_EQ(t.z, (Doubles{3, 6}));
  Doubles fortran;
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 2; ++c)
      for (int r = 0; r < 2; ++r) fortran.push_back(100 * r + 10 * c + k);
  const PointRows rows =
      content<PointRows>(read("a.npy", npy(npy_dictionary("<f8", "2, 2, 3", true), items<double>(fortran))));
  EXPECT_EQ(rows.xyz, (Doubles{0, 1, 2, 10, 11, 12, 100, 101, 102, 110, 111, 112}));
}

TEST(Npy, PointsByTheirCountOfColumns) {
  const PointTable three = points(doubles("2, 3", {1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(three.z, (Doubles{3, 6}));
  EXPECT_TRUE(three.u.empty());
  EXPECT_TRUE(three.line.empty());
  const PointTable five = points(doubles("1, 5", {1, 2, 3, 0.25, 0.5}));
  EXPECT_EQ(five.u, (Doubles{0.25}));
  EXPECT_EQ(five.v, (Doubles{0.5}));
  EXPECT_EQ(points(doubles("1, 6", {1, 2, 3, 0.25, 0.5, 7})).weight, (Doubles{7}));
}

TEST(Npy, NamedColumns) {
  ReadOptions options;
  options.columns = {"u", "v", "-", "z"};
  const PointTable t = points(doubles("2, 4", {0.1, 0.2, 9, 3, 0.3, 0.4, 9, 4}), options);
  EXPECT_EQ(t.u, (Doubles{0.1, 0.3}));
  EXPECT_EQ(t.z, (Doubles{3, 4}));
  EXPECT_TRUE(t.x.empty());
  refuses("a.npy", doubles("2, 3", {1, 2, 3, 4, 5, 6}), "shape 2 x 3 has 3 columns, but 4 are named",
          options);
  refuses("a.npy", doubles("1, 2, 3", {1, 2, 3, 4, 5, 6}), "columns are named", options);
  options.columns = {"u", "v"};
  expect_throw<InvalidInput>([&] { read("a.npy", doubles("1, 2", {1, 2}), options); }, "no column z");
  options.places = true;
  expect_same(points(doubles("1, 2", {1, 2}), options).z, {kNan});
}

TEST(Npy, HeightsAndPointGrids) {
  const Raster r = heights(doubles("2, 4", {1, 2, 3, 4, 5, 6, 7, kNan}));
  EXPECT_EQ(r.rows, 2);
  EXPECT_EQ(r.columns, 4);
  expect_same(r.z, {1, 2, 3, 4, 5, 6, 7, kNan});
  EXPECT_EQ(r.x(0), 0.5);
  EXPECT_EQ(r.y(0), 1.5);  // row 0 is the north
  ReadOptions options;
  options.format = "npy-grid";
  EXPECT_EQ(heights(doubles("2, 3", {1, 2, 3, 4, 5, 6}), options).columns, 3);
  refuses("a.npy", doubles("1, 1, 3", {1, 2, 3}), "neither n x 3", options);

  const PointRows g =
      content<PointRows>(read("a.npy", doubles("2, 2, 3", {1, 2, 3, kNan, kNan, kNan, 4, 5, kNan, 7, 8, 9})));
  EXPECT_EQ(g.row_start, (std::vector<Index>{0, 2, 4}));
  expect_same(g.xyz, {1, 2, 3, kNan, kNan, kNan, kNan, kNan, kNan, 7, 8, 9});
}

TEST(Npy, NodataIsAHole) {
  ReadOptions options;
  options.nodata = -1;
  expect_same(heights(doubles("2, 2", {1, -1, 3, 4}), options).z, {1, kNan, 3, 4});
  const PointTable t = points(doubles("3, 3", {1, 2, 3, 4, 5, -1, 7, 8, 9}), options);
  EXPECT_EQ(t.z, (Doubles{3, 9}));
  EXPECT_EQ(t.line, (std::vector<Index>{1, 3}));
  const PointRows g = content<PointRows>(read("a.npy", doubles("1, 2, 3", {1, 2, 3, 4, 5, -1}), options));
  expect_same(g.xyz, {1, 2, 3, kNan, kNan, kNan});
  options.nodata = -3.4028234663852886e38;
  expect_same(heights(npy(npy_dictionary("<f4", "1, 2"), items<float>({1, -3.4028235e38})), options).z,
              {1, kNan});
}

TEST(Npy, ShapesOfPoints) {
  // More rows than columns of points: no raster.
  std::vector<double> four, two;
  for (int k = 0; k < 12; ++k) {
    four.insert(four.end(), {1.5 * k, 20.0 - k, 0.1 * k * k, 7});
    two.insert(two.end(), {0.1 * k, 0.01 * k * k});
  }
  const SourceData data = read("a.npy", doubles("12, 4", four));
  EXPECT_EQ(content<PointTable>(data).x[2], 3);
  EXPECT_EQ(data.columns, (std::vector<std::string>{"x", "y", "z", "intensity"}));
  EXPECT_EQ(data.columns_from, "guess");
  ReadOptions options;
  options.format = "npy-grid";
  EXPECT_EQ(heights(doubles("12, 4", four), options).columns, 4);
  EXPECT_EQ(heights(doubles("4, 4", Doubles(16, 1))).rows, 4);
  // Turned: a column is a point.
  Doubles turned;
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < 12; ++k) turned.push_back(four[static_cast<std::size_t>(4 * k + c)]);
  const SourceData columns = read("a.npy", doubles("3, 12", turned));
  EXPECT_EQ(content<PointTable>(columns).y, content<PointTable>(data).y);
  EXPECT_EQ(columns.notes[0], "an array of shape 3 x 12: a column is a point");
  EXPECT_EQ(heights(doubles("4, 12", four)).columns, 12);
  Doubles many = four;
  many.insert(many.end(), four.begin(), four.end());
  refuses("a.npy", doubles("4, 24", many),
          "an array of shape 4 x 24 may be 24 points, one a column, or heights");
  refuses("a.npy", doubles("4, 24", many), "`format = npy-grid`");
  options = {};
  options.columns = {"x", "y", "z", "-"};
  EXPECT_EQ(points(doubles("4, 12", four), options).size(), 12);
  // Of a curve two columns are x, y.
  refuses("a.npy", doubles("12, 2", two), "fit-curve as the x, y of a curve");
  options = {};
  options.curve = options.places = true;
  const SourceData curve = read("a.npy", doubles("12, 2", two), options);
  EXPECT_EQ(content<PointTable>(curve).y[3], 0.09);
  EXPECT_EQ(curve.columns, (std::vector<std::string>{"x", "y"}));
}

TEST(Npy, PointsThatAreNanAreLeftOutWhereAsked) {
  ReadOptions any;
  any.nodata = kNan;
  const PointTable t = points(doubles("2, 3", {kNan, kNan, kNan, 4, 5, 6}), any);
  EXPECT_EQ(t.z, (Doubles{6}));
  EXPECT_EQ(t.line, (std::vector<Index>{2}));
  refuses("a.npy", doubles("2, 3", {1, 2, 3, 4, 5, kNan}),
          "row 2 (from 1), column 3 (z): nan is not a finite number");
  refuses("a.npy", doubles("1, 5", {1, 2, 3, kInf, 0}), "row 1 (from 1), column 4 (u): inf");
  refuses("a.npy", doubles("1, 3", {kNan, kNan, kNan}),
          "row 1 (from 1), column 1 (x): nan is not a finite number");
  refuses("a.npy", doubles("1, 3", {kNan, kNan, kNan}), "every point is NaN", any);
  refuses("a.npy", doubles("1, 2", {1, kInf}), "row 1, column 2 (from 1): the height is infinite");
  refuses("a.npy", doubles("1, 1, 3", {1, kInf, 2}), "row 1, column 1 (from 1): y is infinite");
}

TEST(Npy, RefusesTypesThatAreNoRealNumbers) {
  const auto typed = [](const std::string& type) {
    return npy(npy_dictionary(type, "2, 3"), std::string(96, '\0'));
  };
  refuses("a.npy", typed("|O"), "Python objects, which are never unpickled");
  refuses("a.npy", typed("<c16"), "complex numbers");
  refuses("a.npy", typed("|b1"), "truth values");
  refuses("a.npy", typed("<U4"), "no real numbers");
  refuses("a.npy", typed("<M8[ns]"), "no real numbers");
  refuses("a.npy", typed("<f16"), "numbers of a size");
  refuses("a.npy", typed("<f1"), "numbers of a size");
  refuses("a.npy", npy("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (2,), }", ""),
          "structured array");
}

TEST(Npy, RefusesShapesThatAreNoPoints) {
  refuses("a.npy", doubles("6", {1, 2, 3, 4, 5, 6}), "shape 6 is neither n x 3");
  refuses("a.npy", doubles("", {1}), "shape () holds no points");
  refuses("a.npy", doubles("0, 3", {}), "shape 0 x 3 holds no points");
  refuses("a.npy", doubles("1, 2, 2", {1, 2, 3, 4}), "shape 1 x 2 x 2 is neither");
}

TEST(Npy, ChecksTheShapeAgainstTheFileBeforeItTakesMemory) {
  refuses("a.npy", doubles("3, 3", {1, 2, 3}), "claims 3 x 3 numbers of 8 bytes, but only 24 bytes follow");
  refuses("a.npy", doubles("4294967296, 4294967296", {1}), "bytes follow");
  refuses("a.npy", doubles("9223372036854775807, 9223372036854775807, 3", {1}), "bytes follow");
  refuses("a.npy", doubles("99999999999999999999, 3", {1}), "the shape of the header cannot be read");
  refuses("a.npy", doubles("1, 3", {1, 2, 3, 4}), "make 24 bytes, but 32 follow the header");
}

TEST(Npy, RefusesMalformedHeaders) {
  refuses("a.npy", "hello", "does not begin with \\x93NUMPY");
  refuses("a.npy", "\x93NUMPY\x01", "ends inside the NPY header");
  refuses("a.npy", std::string("\x93NUMPY\x09\0\x02\0{}", 12), "NPY version 9.0 is unknown");
  refuses("a.npy", std::string("\x93NUMPY\x02\0\xff\xff\xff\xff{}", 14), "claims 4294967295 bytes");
  for (const auto& [header, words] : std::vector<std::pair<std::string, std::string>>{
           {"", "'{' is missing"},
           {"{", "a string is missing"},
           {"{'descr", "a string of the header does not end"},
           {"{'descr' '<f8'", "':' is missing"},
           {"{'descr': '<f8', 'fortran_order': Maybe, 'shape': (1, 3)}",
            "\"Maybe\" stands for a truth value"},
           {"{'descr': '<f8', 'fortran_order': False, 'shape': (1, -3)}",
            "the shape of the header cannot be read"},
           {"{'descr': '<f8', 'fortran_order': False, 'shape': (1 3)}",
            "the shape of the header does not end"},
           {"{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3}",
            "the shape of the header does not end"},
           {"{'descr': '<f8', 'fortran_order': False}", "the header lacks"},
           {"{'descr': '<f8', 'descr': '<f8'}", "unexpected key \"descr\""},
           {"{'descr': '<f8', 'order': __import__('os')}", "unexpected key \"order\""},
           {"{'descr': '<f8' 'shape': (1, 3)}", "the header's dictionary does not end"},
           {"{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3)} + 1", "something follows"}})
    refuses("a.npy", npy(header, items<double>({1, 2, 3})), words);
}

}  // namespace
}  // namespace knotfit::test
