#include "report/camera.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scenes.h"
namespace knotfit::report {
namespace {

void expect_orthonormal(const Camera& c) {
  EXPECT_NEAR(length(c.right), 1, 1e-12);
  EXPECT_NEAR(length(c.up), 1, 1e-12);
  EXPECT_NEAR(length(c.toward), 1, 1e-12);
  EXPECT_NEAR(dot(c.right, c.up), 0, 1e-12);
  EXPECT_NEAR(dot(c.right, c.toward), 0, 1e-12);
  EXPECT_NEAR(dot(c.up, c.toward), 0, 1e-12);
  EXPECT_NEAR(dot(cross(c.right, c.up), c.toward), 1, 1e-12);
}

TEST(Camera, IsOrthonormalWhereverItLooksFrom) {
  for (double x : {-1.0, 0.0, 1.0})
    for (double y : {-1.0, 0.0, 1.0})
      for (double z : {-1.0, 0.0, 1.0}) expect_orthonormal(look_from({x, y, z}, {0, 0, 1}));
}

TEST(Camera, ShowsNearerThingsNearer) {
  const Camera c = look_from({0, 0, 1}, {0, 1, 0});
  EXPECT_GT(c.project({0, 0, 0.5}).nearness, c.project({0, 0, -0.5}).nearness);
  EXPECT_GT(c.project({1, 0, 0}).x, c.project({0, 0, 0}).x);
  EXPECT_LT(c.project({0, 1, 0}).y, c.project({0, 0, 0}).y) << "y grows downward on the page";
}

TEST(ChooseView, SeesHeightFieldsFromTheSouthWestAboveThem) {
  const Camera c = choose_view(sample_surface(scenes::heights(scenes::hills), {}, 60));
  EXPECT_LT(c.toward.x, 0);
  EXPECT_LT(c.toward.y, 0);
  const double elevation = std::asin(c.toward.z) * 180 / std::numbers::pi;
  EXPECT_GE(elevation, 34.99);
  EXPECT_LE(elevation, 45.01);
  expect_orthonormal(c);
}

TEST(ChooseView, ShowsTheOutsideOfADomeWhicheverWayItsNormalPoints) {
  const Surface dome = scenes::in_space([](double u, double v) {
    const double x = 2 * u - 1, y = 2 * v - 1;
    return std::vector{x + 0.02 * y, y, 1.2 * (2 - x * x - y * y) / 2};
  });
  for (const Surface& s : {dome, transposed(dome)}) {
    const Camera c = choose_view(sample_surface(s, {}, 60));
    EXPECT_GT(c.toward.z, 0.5);
    EXPECT_GT(visible_share(sample_surface(s, {}, 60), c), 0.8);
  }
}

TEST(ChooseView, NeedsNoMeanNormal) {
  // A closed tube: its normals cancel.
  const Surface tube = scenes::in_space(
      [](double u, double v) {
        return std::vector{std::cos(2 * std::numbers::pi * u), std::sin(2 * std::numbers::pi * u), 3 * v};
      },
      12);
  expect_orthonormal(choose_view(sample_surface(tube, {}, 60)));
}

TEST(VisibleShare, IsAllOfASheetAndHalfOfATube) {
  const SurfaceSamples sheet = sample_surface(scenes::in_space([](double u, double v) {
                                                return std::vector{u, v + 0.01 * u, 0.0};
                                              }),
                                              {}, 60);
  EXPECT_NEAR(visible_share(sheet, look_from({0.3, -0.4, 1}, {0, 0, 1})), 1, 0.01);
  const SurfaceSamples tube = sample_surface(
      scenes::in_space(
          [](double u, double v) {
            return std::vector{std::cos(2 * std::numbers::pi * u), std::sin(2 * std::numbers::pi * u), 2 * v};
          },
          12),
      {}, 60);
  // Two pixels of tolerance at the edge of a tube 51 pixels in radius: acos(1 - 2/51) / pi = 0.09.
  EXPECT_NEAR(visible_share(tube, look_from({1, 0, 0}, {0, 0, 1})), 0.5, 0.1);
}

}  // namespace
}  // namespace knotfit::report
