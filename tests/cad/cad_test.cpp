#include "knotfit/cad.h"

#include <gtest/gtest.h>

#include <thread>

#include "cad/iges_witness.h"
#include "cad/step_witness.h"
#include "formats/support.h"
#include "knotfit/evaluate.h"
#include "knotfit/version.h"
#include "spline/clamped.h"
#include "support/random_splines.h"
#include "support/sampling.h"
namespace knotfit::test {
namespace {

constexpr CadFormat kFormats[] = {CadFormat::step_ap214, CadFormat::step_ap242, CadFormat::iges};
constexpr CadUnit kUnits[] = {CadUnit::millimetre, CadUnit::metre, CadUnit::inch};

double in_millimetres(CadUnit unit) {
  return unit == CadUnit::metre ? 1000 : unit == CadUnit::inch ? 25.4 : 1;
}
std::string extension(CadFormat format) {
  return format == CadFormat::iges ? ".igs" : ".step";
}

/// A bent sheet of any size and place: no fold, no crossing.
Surface sheet(const KnotVector& u, const KnotVector& v, double size = 1, double offset = 0) {
  std::vector<double> net;
  const double a0 = u.first(), a1 = u.last() - a0, b0 = v.first(), b1 = v.last() - b0;
  for (const double a : u.greville())
    for (const double b : v.greville()) {
      const double s = (a - a0) / a1, t = (b - b0) / b1;
      net.insert(net.end(), {offset + size * (s + 0.1 * t * t), offset + size * 1.5 * t,
                             size * 0.3 * std::sin(3 * s) * std::cos(2 * t + s)});
    }
  return Surface(u, v, 3, std::move(net));
}
Surface plain_sheet(double size = 1, double offset = 0) {
  return sheet(KnotVector::uniform(3, 4), KnotVector::uniform(3, 2), size, offset);
}

double diagonal(const Surface& s) {
  double squared = 0;
  for (int d = 0; d < 3; ++d) {
    double low = s.net()[static_cast<std::size_t>(d)], high = low;
    for (std::size_t k = static_cast<std::size_t>(d); k < s.net().size(); k += 3) {
      low = std::min(low, s.net()[k]);
      high = std::max(high, s.net()[k]);
    }
    squared += (high - low) * (high - low);
  }
  return std::sqrt(squared);
}

std::vector<Surface> by_witness(const std::string& text, CadFormat format) {
  return format == CadFormat::iges ? IgesFile(text).surfaces() : StepFile(text).surfaces();
}

Surface scaled(const Surface& s, double factor) {
  std::vector<double> net = s.net();
  for (double& c : net) c *= factor;
  return Surface(s.knots_u(), s.knots_v(), 3, std::move(net));
}

/// Written, then read by the witness and by OpenCASCADE: the same surface point by point.
void expect_exchanged(const Surface& s, CadFormat format, CadUnit unit = CadUnit::millimetre) {
  const TemporaryFolder folder;
  const std::string path = folder.file("part" + extension(format));
  ASSERT_NO_THROW(write_cad(path, {s}, {.format = format, .unit = unit}, false));
  EXPECT_EQ(folder.count(), 1U);
  const double allowed = 1e-9 * diagonal(s);
  const std::vector<Surface> witnessed = by_witness(bytes_of(path), format);
  ASSERT_EQ(witnessed.size(), 1U);
  EXPECT_LE(max_distance(clamped(s), witnessed.front()), allowed);
  EXPECT_EQ(witnessed.front(), clamped(s));  // to the last bit
  const std::vector<Surface> read = read_cad(path, unit);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_LE(max_distance(clamped(s), read.front()), allowed);
}

TEST(CadFile, HoldsTheSurfaceInEveryFormatAndUnit) {
  const Surface s = plain_sheet(40);
  for (const CadFormat format : kFormats)
    for (const CadUnit unit : kUnits) {
      SCOPED_TRACE(extension(format) + " " + std::to_string(static_cast<int>(unit)));
      expect_exchanged(s, format, unit);
      // In another unit than that of the file: once, and not by 25.4 or 1000.
      const TemporaryFolder folder;
      const std::string path = folder.file("part" + extension(format));
      write_cad(path, {s}, {.format = format, .unit = unit}, false);
      for (const CadUnit other : kUnits) {
        const double factor = in_millimetres(unit) / in_millimetres(other);
        const Surface wanted = scaled(s, factor);
        EXPECT_LE(max_distance(wanted, read_cad(path, other).front()), 1e-9 * diagonal(wanted));
      }
      const std::string text = bytes_of(path);
      if (format == CadFormat::iges) {
        const char* flags[] = {",2,2HMM,", ",6,1HM,", ",1,4HINCH,"};
        EXPECT_NE(IgesFile(text).global().find(flags[static_cast<int>(unit)]), std::string::npos);
      } else {
        const char* names[] = {"mm", "m", "inch"};
        EXPECT_EQ(StepFile(text).unit(), names[static_cast<int>(unit)]);
      }
    }
}

TEST(CadFile, HoldsEveryDegree) {
  for (int p = 1; p <= kMaxDegree; ++p)
    for (const CadFormat format : {CadFormat::step_ap242, CadFormat::iges}) {
      SCOPED_TRACE(p);
      expect_exchanged(sheet(KnotVector::uniform(p, 3), KnotVector::uniform(10 - p, 2), 10), format);
    }
}

TEST(CadFile, HoldsUnevenAndMultipleKnotsOverAnyDomain) {
  const std::vector<double> uneven = {1e-5, 0.3, 0.3, 0.30001, 0.7, 0.7, 0.7, 0.999999};
  const KnotVector u = KnotVector::clamped(4, uneven);
  std::vector<double> shifted = {-1000, -1000, -1000, -999.5, 0, 0, 3e3, 3e3, 3e3};
  const KnotVector v(2, shifted), open(3, {0, 1, 2, 4, 7, 8, 9, 13, 14, 15});
  for (const CadFormat format : kFormats) {
    expect_exchanged(sheet(u, v, 10), format);
    expect_exchanged(
        sheet(KnotVector::uniform(3, 2), KnotVector::clamped(3, std::vector<double>(3, 0.5)), 10), format);
    // Unclamped knots are written clamped: the same surface.
    const Surface s = sheet(open, KnotVector::uniform(2, 1), 10);
    const TemporaryFolder folder;
    const std::string path = folder.file("part" + extension(format));
    write_cad(path, {s}, {.format = format}, false);
    EXPECT_LE(max_distance(s, read_cad(path).front()), 1e-9 * diagonal(s));
  }
}

TEST(CadFile, HoldsTinyAndFarAwaySurfaces) {
  for (const CadFormat format : kFormats)
    for (const CadUnit unit : {CadUnit::millimetre, CadUnit::metre}) {
      SCOPED_TRACE(extension(format));
      expect_exchanged(plain_sheet(1e-3), format, unit);
      expect_exchanged(plain_sheet(1e6), format, unit);
      expect_exchanged(plain_sheet(10, 1e6), format, unit);  // a part at UTM coordinates
      expect_exchanged(plain_sheet(10, -123456.789), format, unit);
    }
}

TEST(CadFile, ASurfaceBelowCadsToleranceIsWrittenWholeOrNotAtAll) {
  for (const CadFormat format : kFormats)
    for (const double size : {1e-5, 1e-6, 1e-8, 1e-12}) {
      const TemporaryFolder folder;
      const std::string path = folder.file("part" + extension(format));
      const Surface s = plain_sheet(size);
      try {
        write_cad(path, {s}, {.format = format}, false);
        EXPECT_LE(max_distance(s, read_cad(path).front()), 1e-9 * diagonal(s));
      } catch (const std::exception& error) {
        EXPECT_EQ(folder.count(), 0U) << error.what();
      }
    }
}

TEST(CadFile, HoldsASurfaceWithACollapsedSide) {
  const KnotVector k = KnotVector::uniform(3, 1);
  std::vector<double> net;
  for (const double a : k.greville())
    for (const double b : k.greville()) net.insert(net.end(), {a * std::cos(b), a * std::sin(b), a * a});
  for (const CadFormat format : kFormats) expect_exchanged(scaled(Surface(k, k, 3, net), 20), format);
}

TEST(CadFile, SaysItsSchema) {
  const TemporaryFolder folder;
  const Surface s = plain_sheet(10);
  write_cad(folder.file("a.step"), {s}, {.format = CadFormat::step_ap214}, false);
  EXPECT_NE(bytes_of(folder.file("a.step")).find("AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }"),
            std::string::npos);
  write_cad(folder.file("b.step"), {s}, {.format = CadFormat::step_ap242}, false);
  EXPECT_NE(bytes_of(folder.file("b.step")).find("AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF"),
            std::string::npos);
}

TEST(CadFile, HoldsThePartsName) {
  const TemporaryFolder folder;
  const Surface s = plain_sheet(10);
  CadOptions options{
      .name = "Kotfl\xC3\xBCgel O'Neill (left), a name much longer than the 72 columns of a line; \\"};
  write_cad(folder.file("a.step"), {s}, options, false);
  const std::string text = bytes_of(folder.file("a.step"));
  const std::vector<std::string> product = StepFile(text).first("PRODUCT");
  const std::string encoded =
      "'Kotfl\\X2\\00FC\\X0\\gel O''Neill (left), a name much longer than the 72 columns of a line; \\\\'";
  EXPECT_EQ(product.at(0), encoded);
  EXPECT_EQ(product.at(1), encoded);
  for (const char c : text) EXPECT_TRUE(c == '\n' || (c >= 0x20 && c < 0x7F));
  options.format = CadFormat::iges;
  write_cad(folder.file("a.igs"), {s}, options, false);
  const IgesFile iges(bytes_of(folder.file("a.igs")));
  EXPECT_NE(iges.global().find("Kotfl?gel O'Neill (left)"), std::string::npos);
  EXPECT_NE(iges.directory().find("Kotfl?ge"), std::string::npos);
  options.name = "";
  EXPECT_NO_THROW(write_cad(folder.file("b.igs"), {s}, options, false));
  options.format = CadFormat::step_ap242;
  EXPECT_NO_THROW(write_cad(folder.file("b.step"), {s}, options, false));
}

TEST(CadFile, SaysWhoMadeItAndWhenAsTold) {
  const TemporaryFolder folder;
  CadOptions options{.time_stamp = "2024-02-29T12:34:56"};
  write_cad(folder.file("a.step"), {plain_sheet(10)}, options, false);
  const std::string step = bytes_of(folder.file("a.step"));
  EXPECT_NE(step.find("'2024-02-29T12:34:56'"), std::string::npos);
  EXPECT_NE(step.find("knotfit " + std::string(version())), std::string::npos);
  options.format = CadFormat::iges;
  write_cad(folder.file("a.igs"), {plain_sheet(10)}, options, false);
  const std::string iges = IgesFile(bytes_of(folder.file("a.igs"))).global();
  EXPECT_NE(iges.find("15H20240229.123456"), std::string::npos);
  EXPECT_NE(iges.find("knotfit " + std::string(version())), std::string::npos);
  EXPECT_EQ(iges.find("root"), std::string::npos);  // nobody's account
}

TEST(CadFile, IsTheSameBytesEveryTime) {
  for (const CadFormat format : kFormats) {
    const TemporaryFolder folder;
    const std::string a = folder.file("a" + extension(format)), b = folder.file("b" + extension(format));
    write_cad(a, {plain_sheet(10)}, {.format = format}, false);
    write_cad(folder.file("other.igs"), {plain_sheet(3)}, {.format = CadFormat::iges, .unit = CadUnit::inch},
              false);
    write_cad(b, {plain_sheet(10)}, {.format = format}, false);
    EXPECT_EQ(bytes_of(a), bytes_of(b));
  }
}

TEST(CadFile, HoldsTheFacesOfACadSafeSurface) {
  const std::vector<double> folds = {0.3, 0.6, 0.6, 0.6};
  std::vector<double> net;
  const KnotVector u = KnotVector::clamped(3, folds), v = KnotVector::uniform(2, 5);
  for (const double a : u.greville())
    for (const double b : v.greville())
      net.insert(net.end(), {30 * a, 20 * b, 10 * std::abs(a - 0.6) + b * b});
  const Surface s(u, v, 3, std::move(net));
  const std::vector<Surface> faces = cad_safe(s, {.most_control_points = 6});
  ASSERT_GT(faces.size(), 3U);
  for (const CadFormat format : kFormats) {
    const TemporaryFolder folder;
    const std::string path = folder.file("part" + extension(format));
    write_cad(path, faces, {.format = format}, false);
    const std::vector<Surface> witnessed = by_witness(bytes_of(path), format), read = read_cad(path);
    ASSERT_EQ(witnessed.size(), faces.size());
    ASSERT_EQ(read.size(), faces.size());
    for (const Surface& face : faces) {
      EXPECT_NE(std::find(witnessed.begin(), witnessed.end(), face), witnessed.end());
      EXPECT_NE(std::find(read.begin(), read.end(), face), read.end());
    }
    if (format != CadFormat::iges) {  // sewn: one shell
      EXPECT_EQ(StepFile(bytes_of(path)).count("OPEN_SHELL"), 1);
      EXPECT_EQ(StepFile(bytes_of(path)).count("ADVANCED_FACE"), static_cast<int>(faces.size()));
    }
  }
}

TEST(CadFile, IsReadByManyThreadsAtOnce) {
  const TemporaryFolder folder;
  const Surface s = plain_sheet(10);
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&, k] {
      const CadFormat format = kFormats[k % 3];
      const std::string path = folder.file(std::to_string(k) + extension(format));
      write_cad(path, {s}, {.format = format, .unit = kUnits[k % 3]}, false);
      EXPECT_EQ(read_cad(path, kUnits[k % 3]).front(), s);
    });
  for (std::thread& t : threads) t.join();
}

TEST(CadFile, NothingIsPrinted) {
  const TemporaryFolder folder;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  write_cad(folder.file("a.step"), {plain_sheet(10)}, {}, false);
  write_cad(folder.file("a.igs"), {plain_sheet(10)}, {.format = CadFormat::iges}, false);
  std::ofstream(folder.file("bad.step")) << "ISO-10303-21;\nHEADER;\nnonsense ((;\nEND-ISO-10303-21;\n";
  EXPECT_THROW(read_cad(folder.file("bad.step")), FileError);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(CadFile, RefusesWhatNoCadFileHolds) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.step");
  const KnotVector k = KnotVector::uniform(3, 1);
  const auto refused = [&](const std::vector<Surface>& surfaces, const std::string& words) {
    expect_throw<InvalidInput>([&] { write_cad(path, surfaces, {}, false); }, words);
    EXPECT_EQ(folder.count(), 0U);
  };
  refused({}, "no surface to write");
  refused({Surface()}, "the surface is empty");
  refused({Surface(k, k, 1, std::vector<double>(25, 0.0))}, "has 1 coordinates");
  refused({plain_sheet(), Surface(k, k, 3, std::vector<double>(75, 2.0))}, "surface 2 is a single point");
  const KnotVector torn = KnotVector::clamped(2, std::vector<double>(3, 0.5));
  refused({sheet(torn, k)}, "jumps at u = 0.5");
  refused({sheet(k, torn)}, "cad_safe splits it there");
}

TEST(CadFile, ReplacesOnlyWithForceAndNamesABadTarget) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.step");
  std::ofstream(path) << "old";
  expect_throw<FileError>([&] { write_cad(path, {plain_sheet()}, {}, false); }, "exists already");
  EXPECT_EQ(bytes_of(path), "old");
  write_cad(path, {plain_sheet(10)}, {}, true);
  EXPECT_EQ(read_cad(path).front(), plain_sheet(10));
  expect_throw<FileError>([&] { write_cad(folder.file("none/a.step"), {plain_sheet()}, {}, false); },
                          "does not exist");
  expect_throw<FileError>([&] { write_cad("/dev/null", {plain_sheet()}, {}, true); }, "is no plain file");
}

}  // namespace
}  // namespace knotfit::test
