#include "nearest/largest_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/evaluate.h"
namespace knotfit {
namespace {

/// A plane z = 0 with a bump of control points, over a mesh that is the plane.
Surface bumped(double height) {
  const KnotVector knots = KnotVector::uniform(3, 5);
  const std::vector<double> g = knots.greville();
  std::vector<double> net;
  for (std::size_t i = 0; i < g.size(); ++i)
    for (std::size_t j = 0; j < g.size(); ++j)
      net.insert(net.end(), {g[i], g[j], i == 4 && j == 4 ? height : 0.0});
  return Surface(knots, knots, 3, net);
}

const std::vector<double> kVertices = {-1, -1, 0, 2, -1, 0, 2, 2, 0, -1, 2, 0};
const std::vector<std::array<std::int32_t, 3>> kFaces = {{0, 1, 2}, {0, 2, 3}};

std::vector<double> place(const Surface& surface, double u, double v) {
  std::vector<double> p(3);
  evaluate(surface, u, v, p);
  return p;
}

/// Distances of the surface at the centres of n x n cells.
struct Samples {
  std::vector<double> at, distance, point;
  Samples(const Surface& surface, int n) {
    for (int i = 0; i < n; ++i) at.push_back((i + 0.5) / n);
    for (const double u : at)
      for (const double v : at) {
        const std::vector<double> p = place(surface, u, v);
        point.insert(point.end(), p.begin(), p.end());
        distance.push_back(std::abs(p[2]));
      }
  }
  DistanceGrid grid() const { return {at, at, distance, point}; }
};

TEST(LargestDistance, IsFoundBetweenTheSamples) {
  const Surface surface = bumped(0.3);
  const TriangleTree tree(kVertices, kFaces);
  const Samples coarse(surface, 8);  // its centres lie beside the peak at 1/2, 1/2
  double peak = 0, seen = 0;
  for (int i = 0; i <= 1000; ++i)
    for (int j = 0; j <= 40; ++j) peak = std::max(peak, place(surface, i / 1000.0, 0.48 + 0.001 * j)[2]);
  for (const double d : coarse.distance) seen = std::max(seen, d);
  ASSERT_LT(seen, 0.95 * peak);
  const LargestDistance found = largest_distance(surface, tree, coarse.grid(), {});
  EXPECT_FALSE(found.stopped);
  EXPECT_GE(found.distance, peak / 1.01);
  EXPECT_LE(found.distance, peak * (1 + 1e-6));
  EXPECT_NEAR(found.point[2], found.distance, 1e-12);
  EXPECT_NEAR(place(surface, found.u, found.v)[2], found.distance, 1e-12);
}

TEST(LargestDistance, CellsBesidePlacesWithoutDataAreLeftOut) {
  const Surface surface = bumped(0.3);
  const TriangleTree tree(kVertices, kFaces);
  Samples samples(surface, 8);
  for (int i = 2; i < 6; ++i)
    for (int j = 2; j < 6; ++j) samples.distance[i * 8 + j] = -1;
  const LargestDistance found = largest_distance(surface, tree, samples.grid(), {});
  EXPECT_LT(found.distance, 0.05);
}

}  // namespace
}  // namespace knotfit
