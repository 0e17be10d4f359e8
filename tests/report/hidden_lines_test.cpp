#include "report/hidden_lines.h"

#include <gtest/gtest.h>

#include "report/z_buffer.h"
namespace knotfit::report {
namespace {

// A square sheet over the middle third of a lower one, seen from above.
struct TwoSheets {
  Camera camera = look_from({0, 0, 1}, {0, 1, 0});
  std::vector<ScreenPoint> corners;
  std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  TwoSheets() {
    camera.zoom = 100;
    camera.origin = {150, 150};
    for (double z : {0.0, 0.3})
      for (auto [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
        corners.push_back(camera.project({z > 0 ? x / 3 : x, z > 0 ? y / 3 : y, z}));
  }
};

TEST(HiddenLines, DoNotShowThroughANearerSurface) {
  const TwoSheets scene;
  const ZBuffer buffer(300, 300, scene.corners, scene.triangles);
  const Viewport view{scene.camera, buffer, {0, 0}, 1};
  const std::vector<Vec3> below{{-0.9, 0, 0}, {0.9, 0, 0}}, above{{-0.3, 0, 0.3}, {0.3, 0, 0.3}};
  const auto runs = visible_runs(below, view);
  ASSERT_EQ(runs.size(), 2u);
  const double edge = 100.0 / 3 * 10 / 9.7;  // the upper sheet's half width on the page
  EXPECT_NEAR(runs[0].front().x, 60, 1e-9);
  EXPECT_NEAR(runs[0].back().x, 150 - edge, 4);  // two pixels a step, one of tolerance
  EXPECT_NEAR(runs[1].front().x, 150 + edge, 4);
  ASSERT_EQ(visible_runs(above, view).size(), 1u);
  EXPECT_EQ(visible_runs(above, view)[0].size(), 2u) << "a straight line needs its ends only";
}

TEST(HiddenLines, ShowWhatLiesOnTheSurfaceItself) {
  // A steep wall: within a pixel its depth changes by much.
  const Camera camera = [] {
    Camera c = look_from({0.3, -1, 0.1}, {0, 0, 1});
    c.zoom = 100;
    c.origin = {150, 150};
    return c;
  }();
  std::vector<ScreenPoint> corners;
  for (auto [x, z] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
    corners.push_back(camera.project({x, 0.5 * x, z}));
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}};
  const ZBuffer buffer(300, 300, corners, triangles);
  const Viewport view{camera, buffer, {0, 0}, 1};
  const std::vector<Vec3> line{{-0.9, -0.45, -0.7}, {0.2, 0.1, 0.8}, {0.9, 0.45, -0.3}};
  EXPECT_EQ(visible_runs(line, view).size(), 1u);
}

}  // namespace
}  // namespace knotfit::report
