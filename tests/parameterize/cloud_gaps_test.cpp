#include "parameterize/cloud_gaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace knotfit::cloud {
namespace {

using Triangles = std::vector<std::array<std::int32_t, 3>>;

TEST(CircleRadii, AreThoseThroughTheCorners) {
  // A right triangle's circle has half its longest side as radius; an equilateral one's side over sqrt 3.
  const Triangles triangles = {{0, 1, 2}, {0, 1, 3}};
  const double h = std::sqrt(3.0) / 2;
  const std::vector<double> plane = {0, 0, 1, 0, 0, 2, 0.5, h},
                            space = {0, 0, 7, 1, 0, 7, 0, 2, 7, 0.5, h, 7};
  for (const auto& radii : {circle_radii(triangles, plane, 2), circle_radii(triangles, space, 3)}) {
    ASSERT_EQ(radii.size(), 2u);
    EXPECT_NEAR(radii[0], std::sqrt(5.0) / 2, 1e-14);
    EXPECT_NEAR(radii[1], 1 / std::sqrt(3.0), 1e-14);
  }
}

TEST(Spacing, IsTheMedianRadiusAbout) {
  // A fan of six triangles about vertex 0, one of them many times larger.
  Triangles fan;
  for (std::int32_t k = 0; k < 6; ++k) fan.push_back({0, k + 1, (k + 1) % 6 + 1});
  const Spacing spacing(fan, {1, 1, 1, 50, 1, 1}, 7);
  EXPECT_EQ(spacing.at(0), 1);
  EXPECT_EQ(spacing.radius(3), 50);
}

TEST(LoosePoints, AreThoseThatNoTriangleHas) {
  const std::vector<double> points = {0, 0, 0, 1, 2, 3, 4, 5, 6};
  EXPECT_EQ(loose_points(points, {1, 0, 1}), (std::vector<double>{1, 2, 3}));
}

TEST(BareShare, IsTheShareOfTheBoxWithoutPoints) {
  std::vector<double> places;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j)
      if (i <= 20) places.insert(places.end(), {i / 40.0, j / 40.0});
  const std::size_t n = places.size() / 2;
  const std::vector<double> spacing(n, 1 / 40.0);
  const std::vector<char> all(n, 1);
  EXPECT_EQ(bare_share(places, spacing, all, {0, 0}, {0.5, 1}), 0);
  // Half of the box, less 2.5 spacings.
  EXPECT_NEAR(bare_share(places, spacing, all, {0, 0}, {1, 1}), 0.5 - 2.5 / 40, 0.03);
}

}  // namespace
}  // namespace knotfit::cloud
