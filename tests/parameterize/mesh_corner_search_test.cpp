#include "parameterize/mesh_corner_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh_support.h"
#include "parameterize/mesh_border.h"
namespace knotfit::mesh_map {
namespace {

// A cost with one dip: all four corners a given way along the border.
TEST(CornerSearch, FindsADipAndKeepsItsBudget) {
  const DiskMesh disk = make_disk(test::dome(3, 240, 0.2));
  const Border border(disk, rest_triangles(disk, 0));
  const Corners dip = {13, 70, 120, 201};
  int evaluations = 0;
  const auto cost = [&](const Corners& corners) {
    ++evaluations;
    double best = 1e9;  // whichever corner is called the first
    for (int turn = 0; turn < 4; ++turn) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) {
        const double d = std::abs(border.at(corners[(k + turn) % 4]) - border.at(dip[k])) / border.total();
        sum += std::pow(std::min(d, 1 - d), 2);
      }
      best = std::min(best, sum);
    }
    return best;
  };
  const Corners found = search_corners(border, {}, cost);
  EXPECT_LT(evaluations, 400);
  EXPECT_LE(cost(found), 4 * std::pow(1.0 / 300, 2));

  evaluations = 0;
  search_corners(border, {.most_evaluations = 40}, cost);
  EXPECT_EQ(evaluations, 40);
}

}  // namespace
}  // namespace knotfit::mesh_map
