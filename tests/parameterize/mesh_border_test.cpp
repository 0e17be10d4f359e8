#include "parameterize/mesh_border.h"

#include <gtest/gtest.h>

#include "mesh_support.h"
namespace knotfit::mesh_map {
namespace {

TEST(Border, PlacesEverySideByArcLength) {
  const DiskMesh disk = make_disk(test::sheet(6, 4, 3, 2));
  const Border border(disk, rest_triangles(disk, 0));
  const Corners corners = {2, 7, 11, 18};
  std::vector<double> uv(2 * disk.position.size(), -1);
  border.place(corners, uv);
  const auto at = [&](int k) {
    return std::array<double, 2>{uv[2 * disk.loop[k]], uv[2 * disk.loop[k] + 1]};
  };
  EXPECT_EQ(at(2), (std::array<double, 2>{0, 0}));
  EXPECT_EQ(at(7), (std::array<double, 2>{1, 0}));
  EXPECT_EQ(at(11), (std::array<double, 2>{1, 1}));
  EXPECT_EQ(at(18), (std::array<double, 2>{0, 1}));
  const double whole = border.at(7) - border.at(2);
  for (int k = 3; k < 7; ++k) {
    EXPECT_NEAR(at(k)[0], (border.at(k) - border.at(2)) / whole, 1e-15);
    EXPECT_EQ(at(k)[1], 0);
  }
  for (int k = 12; k < 18; ++k) EXPECT_EQ(at(k)[1], 1);
  for (int k : {19, 0, 1}) EXPECT_EQ(at(k)[0], 0);
}

TEST(Border, FindsTheNearestPlaceAroundTheLoop) {
  const DiskMesh disk = make_disk(test::sheet(5, 5));
  const Border border(disk, rest_triangles(disk, 0));
  for (int k = 0; k < border.size(); ++k) {
    EXPECT_EQ(border.nearest(border.at(k)), k);
    EXPECT_EQ(border.nearest(border.at(k) + 0.4 * border.length(k) - border.total()), k);
    EXPECT_EQ(border.nearest(border.at(k) + 0.6 * border.length(k) + border.total()),
              (k + 1) % border.size());
  }
}

TEST(SharpestCorners, AreThoseOfARectangle) {
  const DiskMesh disk = make_disk(test::sheet(20, 12, 2, 1));
  EXPECT_EQ(sharpest_corners(Border(disk, rest_triangles(disk, 0))), (Corners{0, 20, 32, 52}));
}

TEST(CornersAtEars, MoveToFacesThatWouldGoFlat) {
  Mesh mesh = test::sheet(40, 40);
  // The diagonal of the first cell the other way: vertex 0 is left with one face.
  for (auto& f : mesh.faces) {
    if (f == std::array<std::int32_t, 3>{0, 1, 42}) f = {0, 1, 41};
    if (f == std::array<std::int32_t, 3>{0, 42, 41}) f = {1, 42, 41};
  }
  const DiskMesh disk = make_disk(mesh);
  ASSERT_EQ(disk.halved.size(), 1u);
  const Border border(disk, rest_triangles(disk, 0));
  EXPECT_EQ(corners_at_ears(border, {2, 40, 80, 120}), (Corners{0, 40, 80, 120}));
  EXPECT_EQ(corners_at_ears(border, {40, 80, 120, 158}), (Corners{40, 80, 120, 0}));
  EXPECT_EQ(corners_at_ears(border, {5, 40, 80, 120}), (Corners{5, 40, 80, 120}));  // too far
  EXPECT_EQ(corners_at_ears(border, {0, 1, 80, 120}), (Corners{0, 1, 80, 120}));    // there already
}

}  // namespace
}  // namespace knotfit::mesh_map
