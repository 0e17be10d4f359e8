#include "cloud_files.h"
namespace knotfit::test {
namespace {

using Doubles = std::vector<double>;

PointTable points(const LasFile& file, const ReadOptions& options = {}) {
  return content<PointTable>(read("a.las", las(file), options));
}

const std::vector<LasPoint> kThree = {{100, 200, 300, 1, 2, 1}, {-1, -2, -3, 2, 2, 2}, {7, 8, 9, 1, 1, 2}};

TEST(Las, EveryVersionAndPointFormat) {
  for (int minor = 0; minor <= 4; ++minor)
    for (int format = 0; format <= (minor == 4 ? 10 : minor == 3 ? 5 : 3); ++format)
      for (const int extra : {0, 7}) {
        SCOPED_TRACE(std::to_string(minor) + " " + std::to_string(format));
        const PointTable t = points(
            {.minor = minor, .format = format, .points = kThree, .extra = static_cast<std::uint16_t>(extra)});
        EXPECT_EQ(t.x, (Doubles{1, -0.01, 0.07}));
        EXPECT_EQ(t.y, (Doubles{2, -0.02, 0.08}));
        EXPECT_EQ(t.z, (Doubles{3, -0.03, 0.09}));
        EXPECT_TRUE(t.line.empty());
      }
}

TEST(Las, TellsWhatAPointHolds) {
  const auto told = [](int format) {
    const SourceData data = read("a.las", las({.minor = 4, .format = format, .points = kThree}));
    EXPECT_EQ(data.columns_from, "header");
    std::string names;
    for (const std::string& name : data.columns) names += name + ' ';
    return names;
  };
  const std::string always = "x y z intensity return class ";
  EXPECT_EQ(told(0), always);
  for (const int format : {1, 4, 6, 9}) EXPECT_EQ(told(format), always + "time ");
  for (const int format : {3, 5, 7, 8, 10}) EXPECT_EQ(told(format), always + "time r g b ");
  EXPECT_EQ(told(2), always + "r g b ");
}

TEST(Las, CoordinatesOfAMapKeepTheirMillimetres) {
  LasFile file{.points = {{123456789, 987654321, 1}}, .scale = 0.001, .origin = {500000, 4.6e6, -10}};
  const PointTable t = points(file);
  EXPECT_EQ(t.x[0], 123456789 * 0.001 + 500000);
  EXPECT_EQ(t.y[0], 987654321 * 0.001 + 4.6e6);
  EXPECT_NEAR(t.y[0], 5587654.321, 1e-9);
  EXPECT_EQ(t.z[0], 0.001 - 10);
}

TEST(Las, ClassesAndReturnsAreChosen) {
  const auto z = [](std::vector<int> classes, std::vector<int> returns, int format) {
    ReadOptions options;
    options.classes = std::move(classes);
    options.returns = std::move(returns);
    return points({.minor = 4, .format = format, .points = kThree}, options);
  };
  for (const int format : {1, 6}) {
    EXPECT_EQ(z({2}, {}, format).z, (Doubles{-0.03, 0.09}));
    EXPECT_EQ(z({2}, {}, format).line, (std::vector<Index>{2, 3}));
    EXPECT_EQ(z({}, {1}, format).z, (Doubles{3, 0.09}));
    EXPECT_EQ(z({}, {kLastReturn}, format).z, (Doubles{-0.03, 0.09}));
    EXPECT_EQ(z({}, {2, 1}, format).z, (Doubles{3, -0.03, 0.09}));
    EXPECT_EQ(z({1, 2}, {2}, format).z, (Doubles{-0.03}));
  }
  ReadOptions options;
  options.classes = {6};
  refuses("a.las", las({.points = kThree}),
          "no point is of the classes and returns asked for; there are the classes 1 unclassified (1), 2 "
          "ground (2); "
          "the returns 1 (2), 2 (1)",
          options);
  expect_throw<InvalidInput>([&] { read("a.csv", "1,2,3\n", options); }, "only LAS files have them");
  options.format = "csv";
  expect_throw<InvalidInput>([&] { read("a.las", "1,2,3\n", options); }, "only LAS files have them");
}

TEST(Las, WithheldPointsAreNone) {
  LasFile file{.points = kThree};
  file.points[0].withheld = true;
  const SourceData data = read("a.las", las(file));
  EXPECT_EQ(content<PointTable>(data).line, (std::vector<Index>{2, 3}));
  ASSERT_EQ(data.notes.size(), 3U);
  EXPECT_EQ(data.notes[0], "classes: 2 ground (2)");
  EXPECT_EQ(data.notes[2], "1 points marked as withheld are left out");
  for (LasPoint& p : file.points) p.withheld = true;
  refuses("a.las", las(file), "all 3 points are marked as withheld");
}

TEST(Las, KnownByItsContent) {
  EXPECT_EQ(read("a.bin", las({.points = kThree})).format, "las");
}

TEST(Las, SaysWhatIsWrong) {
  const auto changed = [](auto change) {
    std::string bytes = las({.points = kThree});
    change(bytes);
    return bytes;
  };
  const std::string good = las({.points = kThree});
  refuses("a.las", "hello", "is not a LAS file: it does not begin with LASF");
  refuses("a.las", "%PDF-1.5", "but like a PDF document");
  refuses("a.las", good.substr(0, 100), "ends at byte 100, inside its header");
  refuses("a.las", good.substr(0, good.size() - 1),
          "claims 3 points of 20 bytes, but only 59 bytes follow (room for 2); it is cut off");
  refuses("a.las", changed([](std::string& b) { b[25] = 5; }), "is LAS 1.5; versions 1.0 to 1.4 are read");
  refuses("a.laz", changed([](std::string& b) { b[104] = static_cast<char>(128 + 3); }),
          "compressed point cloud (LAZ)");
  refuses("a.las", changed([](std::string& b) { b[104] = 11; }), "points of format 11");
  refuses("a.las", changed([](std::string& b) { put(b, 105, std::uint16_t{19}); }), "takes 20 bytes a point");
  refuses("a.las", changed([](std::string& b) { put(b, 96, std::uint32_t{100}); }), "begin at byte 100");
  refuses("a.las", changed([](std::string& b) { put(b, 96, std::uint32_t{4000000000}); }),
          "only 0 bytes follow");
  refuses("a.las", changed([](std::string& b) { put(b, 107, std::uint32_t{4000000000}); }),
          "claims 4000000000 points");
  refuses("a.las", changed([](std::string& b) { put(b, 107, std::uint32_t{0}); }), "claims 0 points");
  refuses("a.las", changed([](std::string& b) { put(b, 139, 0.0); }), "the scale or the offset of y");
  refuses("a.las", changed([](std::string& b) { put(b, 155, kNan); }), "the scale or the offset of x");
  refuses("a.las", changed([](std::string& b) { put(b, 147, 1e308); }), "point 1 (from 1): z is not finite");
  std::string wide = las({.minor = 4, .format = 6, .points = kThree});
  put(wide, 247, ~std::uint64_t{0});
  refuses("a.las", wide, "points of 30 bytes, but only 90 bytes follow");
  refuses("a.las", wide.substr(0, 300), "ends at byte 300, inside its header");
}

TEST(Las, CutAnywhereIsRefused) {
  for (const int minor : {2, 3, 4}) {
    const std::string bytes = las({.minor = minor, .format = 3, .points = kThree});
    for (std::size_t size = 1; size < bytes.size(); ++size) refuses("a.las", bytes.substr(0, size), "");
  }
}

}  // namespace
}  // namespace knotfit::test
