#include "solve/data_raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace knotfit {
namespace {

ParameterizedPoints even_points(int nu, int nv, double slope_u, double slope_v) {
  ParameterizedPoints points;
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const double u = i / (nu - 1.0), v = j / (nv - 1.0);
      points.uv.insert(points.uv.end(), {u, v});
      points.values.push_back(slope_u * u + slope_v * v);
    }
  return points;
}

TEST(DataRaster, GoalsAreWeightsTimesTheDerivatives) {
  const DataRaster raster = data_raster(even_points(48, 48, 2, -3), 0.1);
  ASSERT_EQ(raster.weight.size(), static_cast<std::size_t>(raster.cells() * DataRaster::kKinds));
  ASSERT_EQ(raster.goal.size(), raster.weight.size());
  const double wanted[] = {0, 0, 0, 2, -3};
  for (Index c = 0; c < raster.cells(); ++c)
    for (int kind = 0; kind < DataRaster::kKinds; ++kind) {
      const double weight = raster.weight[c * DataRaster::kKinds + kind];
      ASSERT_GE(weight, 0);
      // Between points the goals fade by up to some per cent, as towards a hole.
      EXPECT_NEAR(raster.goal[c * DataRaster::kKinds + kind], wanted[kind] * weight,
                  0.05 * std::max(1.0, std::abs(wanted[kind])) * weight);
    }
}

TEST(DataRaster, SpacingsAreThoseOfTheGrid) {
  const DataRaster raster = data_raster(even_points(41, 41, 1, 1), 0.1);
  const Index middle = raster.side_u / 2 * raster.side_v + raster.side_v / 2;
  EXPECT_NEAR(raster.spacing_u[middle], 1 / 40.0, 0.5 / 40);
  EXPECT_NEAR(raster.spacing_v[middle], 1 / 40.0, 0.5 / 40);
}

TEST(DataRaster, OfAClosedCurveHasTwoPeriods) {
  CurvePoints curve;
  for (int k = 0; k < 60; ++k) {
    const double t = k / 60.0;
    curve.t.push_back(t);
    curve.values.insert(curve.values.end(),
                        {std::cos(6.283185307179586 * t), std::sin(6.283185307179586 * t)});
  }
  EXPECT_EQ(strip_raster(curve, 0.01).end_u, 1);
  curve.closed = true;
  const DataRaster raster = strip_raster(curve, 0.01);
  EXPECT_EQ(raster.end_u, 2);
  EXPECT_EQ(raster.dimension, 3) << "the curve's two and the strip's own";
  // The second period is the first.
  const Index half = raster.cells() / 2 * DataRaster::kKinds;
  for (Index k = 0; k < half; ++k) EXPECT_EQ(raster.weight[k], raster.weight[half + k]);
}

}  // namespace
}  // namespace knotfit
