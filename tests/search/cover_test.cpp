#include "search/cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "search/searches.h"
#include "verify/local_reference.h"
namespace knotfit::test {
namespace {

TEST(Cover, LeavesNoNodeFartherThanItsRadius) {
  const ParameterizedPoints points = synthetic_points("franke", 900);
  const DistinctPoints distinct = distinct_points(points);
  const Neighbours neighbours = plain_neighbours(distinct);
  const auto places = cover_gaps(neighbours, 1, 0.5);
  EXPECT_GT(places.size(), 50u);
  EXPECT_LT(places.size(), 600u);
  for (int i = 0; i <= 120; ++i)
    for (int j = 0; j <= 120; ++j) {
      const double u = i / 120.0, v = j / 120.0;
      const bool border = i == 0 || i == 120 || j == 0 || j == 120;
      double nearest = neighbours.gap(u, v);
      for (const auto& p : places) nearest = std::min(nearest, std::hypot(p[0] - u, p[1] - v));
      EXPECT_LE(nearest, (border ? 0.5 : 1.0) / 30 + 1e-12);
    }
}

}  // namespace
}  // namespace knotfit::test
