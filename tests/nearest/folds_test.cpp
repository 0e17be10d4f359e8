#include "knotfit/folds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "data/meshes.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit {
namespace {

using namespace test;

struct Mapped {
  Mesh mesh;
  std::vector<double> uv;
};

/// Flat, X(u,v) = (u, v, 0).
Mapped flat(int cells) {
  Mapped m{sheet(cells, cells), {}};
  for (Index k = 0; k < m.mesh.vertex_count(); ++k) {
    m.mesh.vertices[3 * k + 2] = 0;
    m.uv.insert(m.uv.end(), {m.mesh.vertices[3 * k], m.mesh.vertices[3 * k + 1]});
  }
  return m;
}

/// (x(u), v, 0), piecewise linear in u through x at the breaks.
Surface pleat(const std::vector<double>& breaks, const std::vector<double>& x) {
  const KnotVector u = KnotVector::clamped(1, std::span(breaks).subspan(1, breaks.size() - 2)),
                   v = KnotVector::uniform(1, 3);
  std::vector<double> net;
  for (const double a : x)
    for (const double b : v.greville()) net.insert(net.end(), {a, b, 0});
  return Surface(u, v, 3, net);
}

TEST(Folds, KnowHowFarTheNormalsAreOff) {
  const Mapped m = flat(20);
  const KnotVector k = KnotVector::uniform(1, 0);
  const double slope = std::tan(std::numbers::pi / 6);
  const Surface tilted(k, k, 3, {0, 0, 0, 0, 1, 0, 1, 0, slope, 1, 1, slope});
  EXPECT_NEAR(measure_folds(tilted, m.mesh, m.uv).normal_angle, 30, 1e-9);
  EXPECT_NEAR(measure_folds(pleat({0, 0.4, 0.5, 1}, {0, 0.4, 0.5, 1}), m.mesh, m.uv).normal_angle, 0, 1e-5);
  // Turned right over on a quarter of the square.
  EXPECT_NEAR(measure_folds(pleat({0, 0.5, 0.75, 1}, {0, 0.5, 0.25, 1}), m.mesh, m.uv).normal_angle, 90,
              1e-6);
}

TEST(Folds, AreTheShareThatTurnsBack) {
  const Mapped m = flat(20);
  const FoldReport none = measure_folds(pleat({0, 0.4, 0.5, 1}, {0, 0.4, 0.5, 1}), m.mesh, m.uv);
  EXPECT_EQ(none.raw, 0);
  EXPECT_EQ(none.blurred, 0);
  EXPECT_EQ(none.flipped, 0);
  EXPECT_TRUE(none.places.empty());
  EXPECT_NEAR(none.covered, 1, 1e-12);
  EXPECT_NEAR(none.least_area, 1, 1e-12);
  EXPECT_NEAR(none.least_sine, 1, 1e-12);
  // Back from 0.6 to 0.5 over u = 0.4..0.5: a tenth of the square, exactly whole cells.
  const FoldReport one = measure_folds(pleat({0, 0.4, 0.5, 1}, {0, 0.6, 0.5, 1}), m.mesh, m.uv);
  EXPECT_NEAR(one.raw, 0.1, 1e-12);
  EXPECT_NEAR(one.pleats, 0.1, 1e-12);
  EXPECT_NEAR(one.blurred, 0.1, 1e-12);
  ASSERT_EQ(one.places.size(), 1u);
  EXPECT_NEAR(one.places[0].share, 0.1, 1e-12);
  EXPECT_GT(one.places[0].u, 0.4);
  EXPECT_LT(one.places[0].u, 0.5);
  EXPECT_GE(one.places[0].point[0], 0.5);
  EXPECT_LE(one.places[0].point[0], 0.6);
}

TEST(Folds, TwoOfThemAreTwoPlacesTheLargerFirst) {
  const Mapped m = flat(20);
  const FoldReport r =
      measure_folds(pleat({0, 0.2, 0.25, 0.6, 0.8, 1}, {0, 0.3, 0.25, 0.9, 0.8, 1}), m.mesh, m.uv);
  ASSERT_EQ(r.places.size(), 2u);
  EXPECT_NEAR(r.places[0].share, 0.2, 1e-12);
  EXPECT_NEAR(r.places[1].share, 0.05, 1e-12);
}

TEST(Folds, SmallDetailOfTheMeshIsNoneOfTheBlurredOnes) {
  // A mesh with a step that overhangs, far narrower than a span; the surface passes straight over it.
  Mapped m = flat(40);
  for (Index k = 0; k < m.mesh.vertex_count(); ++k)
    if (std::abs(m.uv[2 * k] - 0.5) < 1e-9) {
      m.mesh.vertices[3 * k] += 0.03;  // beyond the next column at 0.525
      m.mesh.vertices[3 * k + 2] += 0.01;
    }
  const FoldReport r = measure_folds(pleat({0, 0.5, 1}, {0, 0.5, 1}), m.mesh, m.uv);
  EXPECT_NEAR(r.raw, 0, 0.07);
  EXPECT_EQ(r.blurred, 0);
}

TEST(Folds, SingleNoisyTrianglesDoNotDecide) {
  // A plane at 45 degrees, its mesh with noise: neighbours differ by up to 4.8 cells, so triangles stand beyond the plane's
  // normal where the difference passes 2.
  Random random;
  Mapped m = flat(40);
  for (Index k = 0; k < m.mesh.vertex_count(); ++k)
    m.mesh.vertices[3 * k + 2] = m.mesh.vertices[3 * k] + random.uniform(-0.06, 0.06);
  const KnotVector k = KnotVector::uniform(1, 2);
  std::vector<double> net;
  for (const double a : k.greville())
    for (const double b : k.greville()) net.insert(net.end(), {a, b, a});
  const FoldReport noisy = measure_folds(Surface(k, k, 3, net), m.mesh, m.uv);
  EXPECT_GT(noisy.raw, 0.02);
  EXPECT_EQ(noisy.blurred, 0);
  EXPECT_LT(noisy.pleats, kMostPleats);
  EXPECT_FALSE(folds_over(noisy));
  // The same surface turned back within a span over a smooth mesh does: 3 % of the square, less than the blur sees.
  const Mapped smooth = flat(40);
  const FoldReport pleated =
      measure_folds(pleat({0, 0.48, 0.51, 1}, {0, 0.51, 0.48, 1}), smooth.mesh, smooth.uv);
  EXPECT_NEAR(pleated.pleats, 0.03, 1e-9);
  EXPECT_TRUE(folds_over(pleated));
}

TEST(Folds, SeeASurfaceThatVanishes) {
  const Mapped m = flat(20);
  const FoldReport flat_span = measure_folds(pleat({0, 0.4, 0.5, 1}, {0, 0.5, 0.5, 1}), m.mesh, m.uv);
  EXPECT_EQ(flat_span.least_area, 0);
  EXPECT_NEAR(flat_span.small_area, 0.1, 1e-12);
  EXPECT_NEAR(flat_span.small_sine, 0.1, 1e-12);
}

TEST(Folds, TrianglesTurnedOverAreCounted) {
  Mapped m = flat(4);
  m.uv[2 * 6] = 0.9;  // vertex (1,1) beyond (2,1)
  const FoldReport r = measure_folds(pleat({0, 0.5, 1}, {0, 0.5, 1}), m.mesh, m.uv);
  EXPECT_GT(r.flipped, 0);
}

TEST(Folds, VirtualTrianglesAreLeftOut) {
  Mapped m = flat(20);
  m.mesh.virtual_face.assign(m.mesh.faces.size(), 0);
  for (std::size_t f = 0; f < m.mesh.faces.size(); ++f) {
    double u = 0;
    for (const std::int32_t k : m.mesh.faces[f]) u += m.uv[2 * k] / 3;
    m.mesh.virtual_face[f] = u > 0.4 && u < 0.5;
  }
  const FoldReport r = measure_folds(pleat({0, 0.4, 0.5, 1}, {0, 0.6, 0.5, 1}), m.mesh, m.uv);
  EXPECT_EQ(r.raw, 0);
  EXPECT_EQ(r.blurred, 0);
  EXPECT_NEAR(r.covered, 0.9, 1e-12);
}

TEST(Folds, RefuseWhatCannotBeMeasured) {
  const Mapped m = flat(3);
  const Surface s = pleat({0, 0.5, 1}, {0, 0.5, 1});
  Random random;
  expect_throw<InvalidInput>([&] { measure_folds(Surface(), m.mesh, m.uv); }, "is empty");
  expect_throw<InvalidInput>([&] { measure_folds(random_surface(random, 1), m.mesh, m.uv); }, "1 coordinate");
  expect_throw<InvalidInput>([&] { measure_folds(s, m.mesh, std::vector<double>{1}); },
                             "16 vertices need 32");
  std::vector<double> bad = m.uv;
  bad[7] = NAN;
  expect_throw<InvalidInput>([&] { measure_folds(s, m.mesh, bad); }, "vertex 3 are not finite");
  for (double& x : bad) x = 7;
  expect_throw<InvalidInput>([&] { measure_folds(s, m.mesh, bad); }, "covers no part");
}

}  // namespace
}  // namespace knotfit
