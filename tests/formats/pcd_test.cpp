#include "cloud_files.h"
#include "formats/lzf.h"
namespace knotfit::test {
namespace {

using Doubles = std::vector<double>;

PointTable points(const std::string& bytes, const ReadOptions& options = {}) {
  return content<PointTable>(read("a.pcd", bytes, options));
}

std::string xyz_header(int width, int height, const std::string& data) {
  return pcd_header("x y z", "4 4 4", "F F F", "1 1 1", width, height, data);
}

TEST(Pcd, Ascii) {
  ReadOptions any;
  any.nodata = kNan;
  const PointTable t = points(xyz_header(3, 1, "ascii") + "1 2 3\nnan nan nan\n\n4 5e1 -6", any);
  EXPECT_EQ(t.x, (Doubles{1, 4}));
  EXPECT_EQ(t.y, (Doubles{2, 50}));
  EXPECT_EQ(t.z, (Doubles{3, -6}));
  EXPECT_EQ(t.line, (std::vector<Index>{12, 15}));
}

TEST(Pcd, FieldsOfAnyTypeCountAndOrder) {
  const std::string names = "rgb z normal y u x v", sizes = "4 8 4 2 4 4 4", types = "U F F I F I F",
                    counts = "1 1 3 1 1 1 1";
  const auto record = [](double x, double y, double z, double u, double v) {
    return items<std::uint32_t>({77}) + items<double>({z}) + items<float>({7, 8, 9}) +
           items<std::int16_t>({y}) + items<float>({u}) + items<std::int32_t>({x}) + items<float>({v});
  };
  const std::string one = record(-70000, -5, 0.1, 0.25, 0.5), two = record(1, 2, 4.6e6 + 0.001, 0.75, 1);
  const std::string header = pcd_header(names, sizes, types, counts, 2, 1, "binary");
  const PointTable t = points(header + one + two);
  EXPECT_EQ(t.x, (Doubles{-70000, 1}));
  EXPECT_EQ(t.y, (Doubles{-5, 2}));
  EXPECT_EQ(t.z, (Doubles{0.1, 4.6e6 + 0.001}));
  EXPECT_EQ(t.u, (Doubles{0.25, 0.75}));
  EXPECT_EQ(t.v, (Doubles{0.5, 1}));
  EXPECT_TRUE(t.line.empty());
  // Field by field where it is compressed.
  const std::size_t start[] = {0, 4, 12, 24, 26, 30, 34, 38};
  std::string apart;
  for (std::size_t f = 0; f < 7; ++f)
    for (const std::string& r : {one, two}) apart += r.substr(start[f], start[f + 1] - start[f]);
  const PointTable c = points(pcd_header(names, sizes, types, counts, 2, 1, "binary_compressed") +
                              pcd_compressed(lzf_literal(apart), apart.size()));
  EXPECT_EQ(c.x, t.x);
  EXPECT_EQ(c.y, t.y);
  EXPECT_EQ(c.z, t.z);
  EXPECT_EQ(c.v, t.v);
}

TEST(Pcd, NormalsWhereAllThreeAreThere) {
  const auto header = [](const char* names, const char* encoding) {
    return pcd_header(names, "4 4 4 4 4 4", "F F F F F F", "1 1 1 1 1 1", 2, 1, encoding);
  };
  const PointTable t =
      points(header("x y z normal_x normal_y normal_z", "ascii") + "1 2 3 0 0 1\n4 5 6 nan nan nan");
  EXPECT_EQ(t.z, (Doubles{3, 6}));
  EXPECT_EQ(t.nx, (Doubles{0, 0}));
  EXPECT_EQ(t.nz, (Doubles{1, 0}));
  const PointTable b =
      points(header("nz x y z nx ny", "binary") + items<float>({8, 1, 2, 3, 6, 7, 0, 4, 5, 6, 0, 0}));
  EXPECT_EQ(b.x, (Doubles{1, 4}));
  EXPECT_EQ(b.nx, (Doubles{6, 0}));
  EXPECT_EQ(b.nz, (Doubles{8, 0}));
  EXPECT_TRUE(
      points(header("x y z normal_x normal_y curvature", "ascii") + "1 2 3 0 0 1\n4 5 6 0 0 1").nx.empty());
}

TEST(Pcd, TellsWhatTheFieldsWereTakenFor) {
  using Names = std::vector<std::string>;
  const auto told = [](const char* names, Index width, Index height) {
    const SourceData data =
        read("a.pcd", pcd_header(names, "4 4 4 4 4 4", "F F F F F F", "1 1 1 1 1 1", width, height, "ascii") +
                          "1 2 3 4 5 6\n7 8 9 10 11 12\n");
    EXPECT_EQ(data.columns_from, "header");
    return data.columns;
  };
  EXPECT_EQ(told("x y z normal_x normal_y normal_z", 2, 1), (Names{"x", "y", "z", "nx", "ny", "nz"}));
  EXPECT_EQ(told("x y z normal_x normal_y curvature", 2, 1), (Names{"x", "y", "z", "-", "-", "curvature"}));
  EXPECT_EQ(told("rgb z y x _ ring", 2, 1), (Names{"rgb", "z", "y", "x", "-"}));
  EXPECT_EQ(told("x y z u v intensity", 2, 1), (Names{"x", "y", "z", "u", "v", "intensity"}));
  EXPECT_EQ(told("x y z u v intensity", 1, 2),
            (Names{"x", "y", "z", "-", "-", "intensity"}));  // a camera's grid
}

TEST(Pcd, PaddingIsNotInCompressedData) {
  const std::string header =
      pcd_header("x y z _", "4 4 4 1", "F F F U", "1 1 1 4", 1, 1, "binary_compressed");
  const std::string bytes = items<float>({1, 2, 3});
  EXPECT_EQ(points(header + pcd_compressed(lzf_literal(bytes), 12)).z, (Doubles{3}));
  EXPECT_EQ(points(header + pcd_compressed(lzf_literal(bytes + "1234"), 16)).z, (Doubles{3}));
}

TEST(Pcd, AGridOfPointsKeepsItsHoles) {
  const std::string bytes = xyz_header(2, 2, "binary") +
                            items<float>({1, 2, 3, static_cast<float>(kNan), 5, 6, 7, 8, 9, 10, 11, 12});
  const PointRows rows = content<PointRows>(read("a.pcd", bytes));
  EXPECT_EQ(rows.row_start, (std::vector<Index>{0, 2, 4}));
  expect_same(rows.xyz, {1, 2, 3, kNan, kNan, kNan, 7, 8, 9, 10, 11, 12});
  ReadOptions options;
  options.nodata = 9;
  expect_same(content<PointRows>(read("a.pcd", bytes, options)).xyz,
              {1, 2, 3, kNan, kNan, kNan, kNan, kNan, kNan, 10, 11, 12});
}

TEST(Pcd, OldHeaders) {
  // Version 0.5: COLUMNS, no HEIGHT, no COUNT, no POINTS.
  EXPECT_EQ(points("# .PCD v.5\nCOLUMNS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\n1 2 3\n").z,
            (Doubles{3}));
  EXPECT_EQ(points("FIELDS x y z\r\nSIZE 4 4 4\r\nTYPE F F F\r\nPOINTS 1\r\nDATA ascii\r\n1 2 3\r\n").z,
            (Doubles{3}));
}

TEST(Lzf, RunsAndCopies) {
  // "abc" as it is; 6 bytes from 3 back; 1 byte 1 back, 264 times over.
  const std::string input = std::string("\x02") + "abc" + "\x80\x02" + std::string("\xE0\xFF\x00", 3);
  EXPECT_EQ(decompress_lzf(input, 273), "abcabcabc" + std::string(264, 'c'));
  for (const std::size_t size : {272U, 274U}) EXPECT_FALSE(decompress_lzf(input, size));
  for (std::size_t cut = 0; cut < input.size(); ++cut)
    EXPECT_FALSE(decompress_lzf(input.substr(0, cut), 273));
  EXPECT_FALSE(decompress_lzf(std::string("\x00"
                                          "a\x20\x01",
                                          4),
                              4));  // from before the beginning
  EXPECT_FALSE(decompress_lzf(input, std::size_t{1} << 40));
}

TEST(Pcd, SaysWhatIsWrong) {
  const std::string ascii = xyz_header(2, 1, "ascii");
  refuses("a.pcd", ascii + "1.000 2.000 3.000\n", "ends after 1 of the 2 points");
  refuses("a.pcd", ascii + "1 2 3.000\n4 5\n", ":13: 2 numbers, but the header's fields have 3");
  refuses("a.pcd", ascii + "1 2 3\n4 5 6\n7 8 9\n", ":14: data after the last point");
  refuses("a.pcd", ascii + "1 2 3\n4 abc 6\n", ":13: y: \"abc\" is not a number");
  refuses("a.pcd", ascii + "1 2 3\n4 inf 6\n", ":13: point 2 (from 1): y is not finite");
  refuses("a.pcd", ascii + "nan 2 3\n4 5 nan\n", ":12: point 1 (from 1): x is not finite; `nodata = nan`");
  ReadOptions any;
  any.nodata = kNan;
  refuses("a.pcd", ascii + "nan 2 3\n4 5 nan\n", "every point is NaN", any);
  refuses("a.pcd", xyz_header(1000000, 1000, "ascii") + "1 2 3\n", "only 6 bytes follow; it is cut off");
  const std::string binary = xyz_header(2, 1, "binary") + items<float>({1, 2, 3, 4, 5, 6});
  refuses("a.pcd", binary.substr(0, binary.size() - 1), "claims 2 points, which take 24 bytes, but only 23");
  refuses("a.pcd", "\x89PNG\r\n", "like a PNG image");
  refuses("a.pcd", "1 2 3\n", "is no word of a PCD header");
  refuses("a.pcd", "# nothing\n", "is not a PCD file: it has no lines FIELDS and DATA");
  refuses("a.pcd", "FIELDS x y z\nSIZE 4 4 4\n", "before DATA: it is cut off");
  refuses("a.pcd", std::string(100000, 'x'), "a line without an end");
  const auto header = [](const std::string& lines) {
    return "FIELDS x y z\n" + lines + "DATA ascii\n1 2 3\n";
  };
  refuses("a.pcd", header("SIZE 4 4\n"), ":2: SIZE has 2 values, but there are 3 fields");
  refuses("a.pcd", header("SIZE 4 3 4\nWIDTH 1\n"), "no numbers of type F and 3 bytes");
  refuses("a.pcd", header("SIZE 4 2 4\nWIDTH 1\n"), "no numbers of type F and 2 bytes");
  refuses("a.pcd", header("SIZE 4 9 4\n"), "\"9\" is no number from 1 to 8");
  refuses("a.pcd", header("TYPE F Q F\n"), "TYPE \"Q\"");
  refuses("a.pcd", header("WIDTH 1\nPOINTS 2\n"), "POINTS is 2, but WIDTH x HEIGHT are 1 x 1");
  refuses("a.pcd", header("WIDTH 99999999999999999999\n"), "is no number from");
  refuses("a.pcd", header("WIDTH 1099511627776\nHEIGHT 1099511627776\n"), "WIDTH x HEIGHT");
  refuses("a.pcd", header(""), "the header claims 0 points");
  refuses("a.pcd", "FIELDS x y\nWIDTH 1\nDATA ascii\n1 2\n", "the points have no field z");
  refuses("a.pcd", "FIELDS x y z\nWIDTH 1\nDATA zip\n", "DATA \"zip\": there are ascii, binary");
  refuses("a.pcd", "FIELDS x y z\nFIELDS x y z\n", "a second list of fields");
  refuses("a.pcd", "WIDTH 1\nDATA ascii\n", "the header names no FIELDS");
  const std::string packed = xyz_header(1, 1, "binary_compressed"), bytes = items<float>({1, 2, 3});
  refuses("a.pcd", packed + "123", "ends before the sizes of its compressed data");
  refuses("a.pcd", packed + pcd_compressed(lzf_literal(bytes), 12).substr(0, 15),
          "claims 13 compressed bytes");
  refuses("a.pcd", packed + pcd_compressed(lzf_literal(bytes), 24),
          "take 12 bytes, but the compressed data stands for 24");
  refuses("a.pcd", packed + pcd_compressed("\x20", 12), "the compressed data is damaged");
}

}  // namespace
}  // namespace knotfit::test
