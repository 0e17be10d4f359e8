#include "verify/cell_places.h"

#include <gtest/gtest.h>

#include "support/synthetic.h"
namespace knotfit::verify {
namespace {

Surface with_knots(const std::vector<double>& u, const std::vector<double>& v) {
  const KnotVector ku = KnotVector::clamped(2, u), kv = KnotVector::clamped(2, v);
  return Surface(ku, kv, 1, std::vector<double>(static_cast<std::size_t>(ku.size() * kv.size()), 0.0));
}

ParameterizedPoints lattice(int side) {
  ParameterizedPoints points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) points.uv.insert(points.uv.end(), {(i + 0.5) / side, (j + 0.5) / side});
  points.values.assign(points.uv.size() / 2, 0.0);
  return points;
}

TEST(CellPlaces, AreNoneWhereEveryCellHoldsPoints) {
  EXPECT_TRUE(cell_places(with_knots({0.25, 0.5, 0.75}, {0.5}), lattice(20), 500).empty());
}

TEST(CellPlaces, AreTheMiddlesOfASlitBetweenTwoKnots) {
  const auto places = cell_places(with_knots({0.5, 0.502}, {0.3, 0.6}), lattice(20), 500);
  ASSERT_EQ(places.size(), 3u);
  for (const auto& p : places) EXPECT_NEAR(p[0], 0.501, 1e-15);
  // The smallest of the equally empty first.
  EXPECT_NEAR(places[0][1], 0.15, 1e-15);
}

TEST(CellPlaces, TakeTheEmptiestFirstAndAtMostTheCount) {
  ParameterizedPoints points = lattice(20);
  points.uv.insert(points.uv.end(), {0.501, 0.1});
  points.values.push_back(0);
  const Surface surface = with_knots({0.5, 0.502}, {0.3, 0.6});
  const auto all = cell_places(surface, points, 500);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_NEAR(all[2][1], 0.15, 1e-15);
  EXPECT_EQ(cell_places(surface, points, 2).size(), 2u);
  EXPECT_TRUE(cell_places(surface, points, 0).empty());
}

TEST(CellPlaces, MultipleKnotsMakeNoCell) {
  EXPECT_TRUE(cell_places(with_knots({0.5, 0.5}, {}), lattice(20), 500).empty());
}

}  // namespace
}  // namespace knotfit::verify
