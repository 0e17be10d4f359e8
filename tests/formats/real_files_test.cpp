// Real files against the counts published with them.
#include <algorithm>

#include "support.h"
namespace knotfit::test {
namespace {

Index holes(const std::vector<double>& z) {
  return std::count_if(z.begin(), z.end(), [](double value) { return std::isnan(value); });
}

std::pair<double, double> range(const std::vector<double>& z) {
  std::pair<double, double> out{kInf, -kInf};
  for (const double value : z)
    if (!std::isnan(value)) out = {std::min(out.first, value), std::max(out.second, value)};
  return out;
}

TEST(Samples, Jacksboro) {
  const Raster r = content<Raster>(read_data(sample("jacksboro.asc").string()));
  EXPECT_EQ(r.columns, 403);
  EXPECT_EQ(r.rows, 344);
  EXPECT_EQ(r.dx, 0.000833333333333333);
  EXPECT_EQ(r.x0, -84.41375);
  EXPECT_EQ(holes(r.z), 0);
  EXPECT_EQ(range(r.z), std::pair(236.0, 1076.0));
}

TEST(Samples, Face) {
  const PointTable t = content<PointTable>(read_data(sample("face.uv.csv").string()));
  EXPECT_EQ(t.size(), 17157);
  EXPECT_EQ(range(t.u), std::pair(0.0, 1.0));
  EXPECT_EQ(range(t.v), std::pair(0.0, 1.0));
  EXPECT_EQ(t.line.front(), 2);
  EXPECT_EQ(t.line.back(), 17158);
  EXPECT_EQ(t.y[0], 0.231224);
}

class SharedData : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("KNOTFIT_DATA");
    if (folder == nullptr) GTEST_SKIP() << "KNOTFIT_DATA is not set";
    folder_ = folder;
  }
  SourceData file(const std::string& name) const { return read_data((folder_ / name).string()); }
  std::filesystem::path folder_;
};

TEST_F(SharedData, ParameterizedSets) {
  for (const auto& [name, rows] : std::vector<std::pair<std::string, Index>>{{"deepdrawing", 2969},
                                                                             {"mask", 1590},
                                                                             {"three_peaks", 1907},
                                                                             {"blade_patch", 6922},
                                                                             {"face", 17157},
                                                                             {"mountain", 25600}}) {
    const PointTable t = content<PointTable>(file(name + ".uv.csv"));
    EXPECT_EQ(t.size(), rows) << name;
    EXPECT_EQ(range(t.u), std::pair(0.0, 1.0)) << name;
    EXPECT_EQ(range(t.v), std::pair(0.0, 1.0)) << name;
  }
}

TEST_F(SharedData, Terrain) {
  const Raster tidal = content<Raster>(file("tidal_holes.asc"));
  EXPECT_EQ(tidal.columns, 300);
  EXPECT_EQ(tidal.rows, 452);
  EXPECT_EQ(tidal.dx, 2);
  EXPECT_EQ(tidal.nodata, 999);
  EXPECT_EQ(holes(tidal.z), 35152);
  EXPECT_NEAR(range(tidal.z).first, -2.60935, 5e-6);
  EXPECT_NEAR(range(tidal.z).second, 8.46138, 5e-6);
  const Raster boulder = content<Raster>(file("boulder_srtm.asc"));
  EXPECT_EQ(boulder.columns, 240);
  EXPECT_EQ(boulder.rows, 144);
  EXPECT_EQ(holes(boulder.z), 0);
  EXPECT_EQ(range(boulder.z), std::pair(1943.0, 3286.0));
  const Raster metres = content<Raster>(file("jacksboro_metres.asc"));
  EXPECT_EQ(metres.dx, 74.401171);
  EXPECT_EQ(metres.dy, 92.662567);
  const Raster degrees = content<Raster>(file("jacksboro.asc"));
  EXPECT_EQ(metres.z, degrees.z);
}

TEST_F(SharedData, RowsAndDepthImage) {
  const PointRows rows = content<PointRows>(file("face_rows.txt"));
  EXPECT_EQ(rows.rows(), 90);
  EXPECT_EQ(rows.size(), 19089);
  Index shortest = 1 << 30, longest = 0;
  for (Index r = 0; r < rows.rows(); ++r) {
    const Index length =
        rows.row_start[static_cast<std::size_t>(r) + 1] - rows.row_start[static_cast<std::size_t>(r)];
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  EXPECT_EQ(shortest, 21);
  EXPECT_EQ(longest, 554);
  const PointRows depth = content<PointRows>(file("depth_camera.npy"));
  EXPECT_EQ(depth.rows(), 240);
  EXPECT_EQ(depth.common_length(), 320);
  EXPECT_EQ(depth.size() - holes(depth.xyz) / 3, 60359);
}

TEST_F(SharedData, LaserScan) {
  const PointTable all = content<PointTable>(file("autzen.las"));
  EXPECT_EQ(all.size(), 110000);
  EXPECT_EQ(range(all.z), std::pair(406.26, 520.51));
  ReadOptions ground;
  ground.classes = {2};
  EXPECT_EQ(content<PointTable>(read_data((folder_ / "autzen.las").string(), ground)).size(), 26107);
  const std::string cut = (folder_ / "bad_las_points.las").string();
  expect_throw<FileError>([&] { read_data(cut); },
                          "claims 110000 points of 34 bytes, but only 691 bytes follow (room "
                          "for 20); it is cut off");
}

TEST_F(SharedData, CurvesHaveNoZ) {
  expect_throw<FileError>([&] { file("blade_profile.csv"); },
                          "there is no column z in the header \"x\", \"y\"");
}

}  // namespace
}  // namespace knotfit::test
