#include "nearest/surface_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_splines.h"
namespace knotfit {
namespace {

using namespace knotfit::test;

TEST(SurfaceTree, IsAsNearAsTheNearestOfManySamples) {
  Random random;
  const KnotVector knots = KnotVector::uniform(3, 3);
  const std::vector<double> g = knots.greville();
  std::vector<double> net;
  for (const double u : g)
    for (const double v : g) net.insert(net.end(), {u, v, 0.4 * std::sin(7 * u) * std::cos(5 * v)});
  const CellPolynomials surface(Surface(knots, knots, 3, net));
  const SurfaceTree tree(surface);
  std::vector<Vec3> samples;
  for (int i = 0; i <= 100; ++i)
    for (int j = 0; j <= 100; ++j) samples.push_back(surface.jet(i / 100.0, j / 100.0).s);
  for (int k = 0; k < 100; ++k) {
    const Vec3 p{random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5), random.uniform(-1, 1)};
    double least = INFINITY;
    for (const Vec3& s : samples) least = std::min(least, squared(s - p));
    for (const bool hinted : {false, true}) {
      const double start[2] = {random.unit(), random.unit()};
      const SurfaceTree::Closest found = tree.closest(p, hinted ? start : nullptr);
      EXPECT_LE(found.squared, least * (1 + 1e-12)) << "no sample is nearer";
      EXPECT_NEAR(found.squared, squared(surface.jet(found.u, found.v).s - p), 1e-12);
    }
  }
}

TEST(SurfaceTree, FindsAPointOfTheSurfaceAgain) {
  Random random;
  const KnotVector knots = KnotVector::uniform(2, 2);
  std::vector<double> net;
  for (const double u : knots.greville())
    for (const double v : knots.greville()) net.insert(net.end(), {u, v, u * u - v});
  const CellPolynomials surface(Surface(knots, knots, 3, net));
  const SurfaceTree tree(surface);
  for (int k = 0; k < 50; ++k) {
    const double u = random.unit(), v = random.unit();
    const SurfaceTree::Closest found = tree.closest(surface.jet(u, v).s);
    EXPECT_NEAR(found.u, u, 1e-7);
    EXPECT_NEAR(found.v, v, 1e-7);
    EXPECT_NEAR(found.squared, 0, 1e-14);
  }
}

}  // namespace
}  // namespace knotfit
