// Curves through STEP and IGES.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include "formats/support.h"
#include "knotfit/curve_io.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

class CadCurve : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name); }
  TemporaryFolder folder_;
};

Curve wave(int degree) {
  Random random(degree);
  const KnotVector knots = KnotVector::clamped(degree, std::vector<double>{0.2, 0.5, 0.6});
  return Curve(knots, 3, random_numbers(random, knots.size() * 3, 10));
}

TEST_F(CadCurve, ComesBackInEveryFormatAndUnit) {
  for (const CadFormat format : {CadFormat::step_ap214, CadFormat::step_ap242, CadFormat::iges})
    for (const CadUnit unit : {CadUnit::millimetre, CadUnit::metre, CadUnit::inch}) {
      const std::string file = path(format == CadFormat::iges ? "a.igs" : "a.step");
      CadOptions options;
      options.format = format;
      options.unit = unit;
      const Curve curve = wave(3);
      write_cad_curve(file, curve, options, true);
      const std::vector<Curve> read = read_cad_curves(file, unit);
      ASSERT_EQ(read.size(), 1u);
      EXPECT_EQ(read[0].degree(), 3);
      ASSERT_EQ(read[0].size(), curve.size());
      for (std::size_t k = 0; k < curve.control_points().size(); ++k)
        EXPECT_NEAR(read[0].control_points()[k], curve.control_points()[k], 1e-13 * 10);
    }
}

TEST_F(CadCurve, TheSameCurveGivesTheSameBytes) {
  const auto bytes = [&](const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  for (const char* name : {"a.step", "a.igs"}) {
    CadOptions options;
    if (name[2] == 'i') options.format = CadFormat::iges;
    write_cad_curve(path(name), wave(2), options, true);
    const std::string first = bytes(path(name));
    write_cad_curve(path(name), wave(2), options, true);
    EXPECT_EQ(first, bytes(path(name)));
  }
}

TEST_F(CadCurve, AClosedOneComesBackTheSameCurve) {
  // Ends that meet in value and slope: OpenCASCADE takes it for a periodic one.
  const KnotVector knots = KnotVector::clamped(2, std::vector<double>{0.25, 0.5, 0.75});
  const Curve closed(knots, 3, {1, 0, 0, 1, 1, 0, -1, 1, 0, -1, -1, 0, 1, -1, 0, 1, 0, 0});
  for (const char* name : {"a.step", "a.igs"}) {
    CadOptions options;
    if (name[2] == 'i') options.format = CadFormat::iges;
    write_cad_curve(path(name), closed, options, true);
    const std::vector<Curve> read = read_cad_curves(path(name));
    ASSERT_EQ(read.size(), 1u);
    for (int k = 0; k <= 40; ++k) {
      const std::vector<double> t{k / 40.0}, p = evaluate(read[0], t), q = evaluate(closed, t);
      for (int e = 0; e < 3; ++e) EXPECT_NEAR(p[e], q[e], 1e-14);
    }
  }
}

TEST_F(CadCurve, RefusesWhatIsNoEdge) {
  const auto refused = [&](const Curve& curve, const std::string& words) {
    expect_throw<InvalidInput>([&] { write_cad_curve(path("a.step"), curve, {}, true); }, words);
    EXPECT_FALSE(std::filesystem::exists(path("a.step")));
  };
  Random random(1);
  const KnotVector knots = KnotVector::uniform(2, 1);
  refused(Curve(knots, 2, random_numbers(random, 8)), "the curve has 2 coordinates");
  refused(Curve(KnotVector(1, {0, 0.2, 0.6, 1}), 3, random_numbers(random, 6)),
          "no knots of full multiplicity");
  refused(Curve(KnotVector::clamped(1, std::vector<double>{0.5, 0.5}), 3, random_numbers(random, 12)),
          "the curve jumps at t = 0.5");
  expect_throw<FileError>([&] { read_cad_curves(path("missing.step")); }, "missing.step");
}

}  // namespace
}  // namespace knotfit::test
