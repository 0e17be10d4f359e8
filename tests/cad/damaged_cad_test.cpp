// Damaged STEP and IGES files: an error or a surface, never a crash, a hang, or more memory than the file allows.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include "formats/support.h"
#include "knotfit/cad.h"
#include "knotfit/curve_io.h"
namespace knotfit::test {
namespace {

constexpr std::size_t kLargest = 100'000;
constexpr double kSeconds = 60;  // a reading that takes longer hangs

/// Changed files of each kind: KNOTFIT_TEST_DAMAGES of the environment, since OpenCASCADE takes its time with each.
int damages() {
  const char* const asked = std::getenv("KNOTFIT_TEST_DAMAGES");
  return asked != nullptr ? std::atoi(asked) : 150;
}

Surface sheet(int size, double bend) {
  const KnotVector k = KnotVector::uniform(3, size - 4);
  std::vector<double> net;
  for (const double a : k.greville())
    for (const double b : k.greville())
      net.insert(net.end(), {10 * a, 7 * b, std::sin(bend * a) * std::cos(2 * b + a)});
  return Surface(k, k, 3, std::move(net));
}

struct Sample {
  std::string name, bytes;
};

std::vector<Sample> samples() {
  const TemporaryFolder folder;
  std::vector<Sample> all;
  const auto keep = [&](const char* name) { all.push_back({name, bytes_of(folder.file(name))}); };
  const auto surfaces = [&](const char* name, const std::vector<Surface>& s, const CadOptions& options) {
    write_cad(folder.file(name), s, options, false);
    keep(name);
  };
  surfaces("scan.step", {sheet(26, 3)}, {.format = CadFormat::step_ap242});
  surfaces("inch.step", {sheet(5, 1)}, {.format = CadFormat::step_ap214, .unit = CadUnit::inch});
  surfaces("scan.igs", {sheet(22, 3)}, {.format = CadFormat::iges});
  surfaces("small.igs", {sheet(5, 1)}, {.format = CadFormat::iges, .unit = CadUnit::metre});
  std::vector<double> fold = {0.5, 0.5, 0.5}, net;
  const KnotVector u = KnotVector::clamped(3, fold), v = KnotVector::uniform(3, 1);
  for (const double a : u.greville())
    for (const double b : v.greville()) net.insert(net.end(), {10 * a, 7 * b, std::abs(a - 0.5)});
  surfaces("faces.step", cad_safe(Surface(u, v, 3, net)), {});
  std::vector<double> points;
  for (const double a : sheet(9, 1).knots_u().greville())
    points.insert(points.end(), {a, a * a, std::sin(3 * a)});
  const Curve curve(sheet(9, 1).knots_u(), 3, std::move(points));
  write_cad_curve(folder.file("curve.step"), curve, {}, false);
  keep("curve.step");
  write_cad_curve(folder.file("curve.igs"), curve, {.format = CadFormat::iges}, false);
  keep("curve.igs");
  return all;
}

/// The most memory this program has had at once, or 0 where the system does not say.
double peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return 1024 * std::atof(line.c_str() + 6);
  return 0;
}
void forget_peak() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

class DamagedCad : public testing::Test {
 protected:
  /// Reads, and holds the file to an error or finite control points. \return whether it was read
  bool try_reading(const std::string& name, const std::string& bytes) const {
    const std::string path = folder_.file(name);
    std::ofstream(path, std::ios::binary) << bytes;
    bool good = true;
    forget_peak();
    const double before = peak_bytes();
    const std::clock_t start = std::clock();
    try {
      if (name.starts_with("curve")) {
        for (const Curve& c : read_cad_curves(path)) expect_finite(c.control_points());
      } else {
        for (const Surface& s : read_cad(path)) expect_finite(s.net());
      }
    } catch (const FileError& error) {
      EXPECT_EQ(std::string(error.what()).find(path), 0U) << error.what();
      EXPECT_LT(std::string(error.what()).size(), 1000U);
      good = false;
    }
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, kSeconds);
#ifndef KNOTFIT_SANITIZED  // sanitizers keep what was freed
    EXPECT_LE(peak_bytes() - before, 10 * static_cast<double>(bytes.size()) + 64e6);
#else
    static_cast<void>(before);
#endif
    return good;
  }
  static void expect_finite(const std::vector<double>& numbers) {
    EXPECT_FALSE(numbers.empty());
    for (const double x : numbers) EXPECT_TRUE(std::isfinite(x));
  }
  TemporaryFolder folder_;
};

TEST_F(DamagedCad, TheSamplesThemselvesAreSound) {
  std::size_t largest = 0;
  for (const Sample& s : samples()) {
    EXPECT_TRUE(try_reading(s.name, s.bytes)) << s.name;
    EXPECT_LE(s.bytes.size(), kLargest) << s.name;
    largest = std::max(largest, s.bytes.size());
  }
  EXPECT_GT(largest, 8 * kLargest / 10);
}

TEST_F(DamagedCad, TruncatedAtEvery64thByte) {
  for (const Sample& s : samples())
    for (std::size_t size = 0; size + 64 < s.bytes.size(); size += 64)
      EXPECT_FALSE(try_reading(s.name, s.bytes.substr(0, size))) << s.name << " cut at " << size;
}

TEST_F(DamagedCad, BytesChangedAtRandom) {
  Random random;
  for (const Sample& s : samples())
    for (int k = 0; k < damages(); ++k) {
      const std::string bytes = damaged(s.bytes, random, "0123456789#$*'(),.;=-EA \n", 3, 5);
      try_reading(s.name, bytes);
      if (HasFailure()) {
        FAIL() << s.name << ", change " << k << ":\n" << bytes;
      }
    }
}

}  // namespace
}  // namespace knotfit::test
