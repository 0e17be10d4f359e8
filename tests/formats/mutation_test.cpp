// Damaged files: an error or a right result, and never more memory than the file's size allows.
#include "allocation_watch.h"
#include "cloud_files.h"
namespace knotfit::test {
namespace {

struct Sample {
  std::string name;
  std::string bytes;
};

std::vector<Sample> samples() {
  std::vector<double> numbers;
  for (int k = 0; k < 60; ++k) numbers.push_back(std::sin(k) * 100);
  std::string csv = "x,y,z,u,v\n", rows,
              grid = "ncols 8\nnrows 6\nxllcorner 0.5\nyllcorner -7\ndx 2\ndy 3\nNODATA_value -9999\n";
  for (int k = 0; k < 20; ++k) {
    csv += std::to_string(k) + "," + std::to_string(std::sin(k)) + ",1e-3,0.25," + std::to_string(k / 20.0) +
           "\n";
    rows += std::to_string(k % 5) + " " + std::to_string(k / 5) + " " + std::to_string(std::cos(k)) + "\n" +
            (k % 5 == 4 ? "\n" : "");
  }
  for (int k = 0; k < 48; ++k) grid += std::to_string(std::cos(k) * 100) + (k % 8 == 7 ? "\n" : " ");
  std::vector<LasPoint> scan;
  for (int k = 0; k < 12; ++k) scan.push_back({k, -k * k, 1000 * k, k % 2 + 1, 2, k % 3});
  SurfaceDocument document;
  document.surface = Surface(KnotVector::uniform(2, 2), KnotVector::uniform(3, 0), 3,
                             std::vector<double>(numbers.begin(), numbers.end()));
  document.options = "{\"tol\": [1, {\"a\": null}]}";
  return {{"a.csv", csv},
          {"a.txt", rows},
          {"a.asc", grid},
          {"points.npy", doubles("20, 3", numbers)},
          {"grid.npy", npy(npy_dictionary(">f4", "6, 10", true), items<float>(numbers, true), 2)},
          {"rows.npy", doubles("4, 5, 3", numbers)},
          {"a.json", to_json(document)},
          {"old.las", las({.points = scan})},
          {"new.las", las({.minor = 4, .format = 7, .points = scan})},
          {"a.pcd", pcd_header("x y z", "4 4 4", "F F F", "1 1 1", 3, 2, "ascii") +
                        "1 2 3\n4 5 6\n7 8 9\n1 1 1\n2 2 2\nnan nan nan\n"},
          {"binary.pcd",
           pcd_header("x y z", "1 4 8", "I F F", "1 1 1", 2, 3, "binary") + std::string(78, '\x12')},
          {"packed.pcd", pcd_header("x y z", "4 4 4", "F F F", "1 1 1", 20, 1, "binary_compressed") +
                             pcd_compressed(lzf_literal(items<float>(numbers)), 240)}};
}

/// What every result must hold, whatever the file said.
void expect_sound(const SourceData& data) {
  if (const auto* t = std::get_if<PointTable>(&data.content)) {
    EXPECT_GT(t->size(), 0);
    for (const auto* column : {&t->x, &t->y, &t->z, &t->u, &t->v, &t->weight}) {
      EXPECT_TRUE(column->empty() || column->size() == t->z.size());
      for (const double value : *column) EXPECT_TRUE(std::isfinite(value));
    }
    EXPECT_TRUE(t->line.empty() || t->line.size() == t->z.size());
    EXPECT_EQ(t->x.size(), t->y.size());
    EXPECT_EQ(t->u.size(), t->v.size());
  } else if (const auto* r = std::get_if<Raster>(&data.content)) {
    EXPECT_EQ(r->z.size(), static_cast<std::size_t>(r->columns * r->rows));
    EXPECT_TRUE(r->dx > 0 && r->dy > 0 && std::isfinite(r->x0 + r->y0 + r->nodata));
    for (const double z : r->z) EXPECT_FALSE(std::isinf(z));
  } else {
    const PointRows& rows = std::get<PointRows>(data.content);
    EXPECT_GE(rows.rows(), 1);
    EXPECT_EQ(rows.row_start.front(), 0);
    EXPECT_EQ(rows.row_start.back(), rows.size());
    EXPECT_TRUE(std::is_sorted(rows.row_start.begin(), rows.row_start.end()));
    for (const double value : rows.xyz) EXPECT_FALSE(std::isinf(value));
  }
}

/// \return whether it was read
bool try_reading(const std::string& name, const std::string& bytes) {
  largest_request = 0;
  bool good = true;
  try {
    if (name.ends_with(".json"))
      surface_from_json(bytes, name);
    else
      expect_sound(read(name, bytes));
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()).find(name), 0U) << error.what();
    EXPECT_LT(std::string(error.what()).size(), 1000U);
    good = false;
  }
  // 8 bytes for a digit and what parts it from the next, doubled by a vector's growth.
  EXPECT_LE(largest_request.load(), 16 * bytes.size() + 4096) << name;
  return good;
}

TEST(DamagedFiles, TheSamplesThemselvesAreSound) {
  for (const Sample& s : samples()) EXPECT_TRUE(try_reading(s.name, s.bytes)) << s.name;
}

TEST(DamagedFiles, TruncatedAnywhere) {
  for (const Sample& s : samples())
    for (std::size_t size = 0; size < s.bytes.size(); ++size) {
      const bool good = try_reading(s.name, s.bytes.substr(0, size));
      // Text may end at any of its lines; what says its own size may not.
      if (s.name.ends_with(".npy") || s.name.ends_with(".las") || s.name.ends_with("y.pcd") ||
          s.name.ends_with("d.pcd")) {
        EXPECT_FALSE(good) << s.name << " cut at " << size;
      }
    }
}

TEST(DamagedFiles, TruncatedSamplesAtEvery64thByte) {
  for (const char* name : {"face.uv.csv", "jacksboro.asc"}) {
    const std::string bytes = bytes_of(sample(name)).substr(0, 40000);
    for (std::size_t size = 0; size < bytes.size(); size += 64) try_reading(name, bytes.substr(0, size));
  }
}

TEST(DamagedFiles, TenThousandRandomChangesOfEach) {
  using namespace std::string_view_literals;
  constexpr std::string_view kAlphabet = "0123456789eE+-. \n,;\t#\"()[]{}naif\0"sv;
  Random random;
  for (const Sample& s : samples()) {
    int good = 0;
    for (int k = 0; k < 10000; ++k) {
      const std::string bytes = damaged(s.bytes, random, kAlphabet, 4, 9);
      good += try_reading(s.name, bytes);
      if (HasFatalFailure() || HasNonfatalFailure()) FAIL() << s.name << ":\n" << bytes;
    }
    EXPECT_GT(good, 0) << s.name;
    EXPECT_LT(good, 10000) << s.name;
  }
}

}  // namespace
}  // namespace knotfit::test
