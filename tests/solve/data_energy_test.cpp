#include "solve/data_energy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/synthetic.h"
namespace knotfit::test {
namespace {

struct Integrals {
  std::vector<double> weight, goal;
  Integrals(const DataEnergy& energy, double u0, double u1, double v0, double v1)
      : weight(DataEnergy::kKinds), goal(energy.goal_size()) {
    std::vector<double> scratch(energy.scratch_size());
    energy.integrate(u0, u1, v0, v1, weight.data(), goal.data(), scratch.data());
  }
};

// Cells of few raster cells are added up, larger ones come from summed tables: both are the same integral.
TEST(DataEnergy, IntegralsAreAdditive) {
  const ParameterizedPoints points = uneven_points(3000, 5);
  const DataEnergy energy(data_raster(points, 0.01));
  const Integrals whole(energy, 0.1, 0.9, 0.2, 0.7);
  for (int parts : {2, 50}) {
    std::vector<double> sum(DataEnergy::kKinds, 0.0), mean(DataEnergy::kKinds * points.dimension, 0.0);
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        const Integrals part(energy, 0.1 + 0.8 * i / parts, 0.1 + 0.8 * (i + 1) / parts,
                             0.2 + 0.5 * j / parts, 0.2 + 0.5 * (j + 1) / parts);
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part.weight[k];
        for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += part.goal[k];
      }
    // Sums over the square lose at most some 1e4 roundings of the whole.
    const Integrals square(energy, 0, 1, 0, 1);
    for (std::size_t k = 0; k < sum.size(); ++k)
      EXPECT_NEAR(sum[k], whole.weight[k], 1e-11 * square.weight[k]) << parts;
    for (std::size_t k = 0; k < mean.size(); ++k) {
      double size = 0;
      for (double g : square.goal) size = std::max(size, std::abs(g));
      EXPECT_NEAR(mean[k], whole.goal[k], 1e-10 * size) << parts << " " << k;
    }
  }
}

// A plane's slopes are what the goals say, and its second derivatives are 0.
TEST(DataEnergy, GoalsAreTheDerivativesOfTheData) {
  ParameterizedPoints points;  // even: no place counts as a hole
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      points.uv.insert(points.uv.end(), {i / 63.0, j / 63.0});
      points.values.push_back(2 * i / 63.0 - 3 * j / 63.0);
    }
  const DataEnergy energy(data_raster(points, 0.1));
  const Integrals cell(energy, 0.4, 0.6, 0.3, 0.5);
  EXPECT_NEAR(cell.goal[DataRaster::kU], 2 * cell.weight[DataRaster::kU], 1e-2 * cell.weight[DataRaster::kU]);
  EXPECT_NEAR(cell.goal[DataRaster::kV], -3 * cell.weight[DataRaster::kV],
              1e-2 * cell.weight[DataRaster::kV]);
  for (int kind : {DataRaster::kUu, DataRaster::kUv, DataRaster::kVv})
    EXPECT_NEAR(cell.goal[kind], 0, 1e-6 * cell.weight[kind]);
}

// Where there is no data there is nothing to follow: a hole is held more, and to no slope.
TEST(DataEnergy, HolesAreHeldMore) {
  ParameterizedPoints full = synthetic_points("franke", 6000), holed;
  for (Index k = 0; k < full.size(); ++k) {
    if (std::hypot(full.u(k) - 0.5, full.v(k) - 0.5) < 0.2) continue;
    holed.uv.insert(holed.uv.end(), {full.u(k), full.v(k)});
    holed.values.push_back(full.values[k]);
  }
  const Integrals with(DataEnergy(data_raster(holed, 0.01)), 0.45, 0.55, 0.45, 0.55),
      without(DataEnergy(data_raster(full, 0.01)), 0.45, 0.55, 0.45, 0.55);
  for (int kind : {DataRaster::kUu, DataRaster::kVv, DataRaster::kU, DataRaster::kV})
    EXPECT_GT(with.weight[kind], without.weight[kind]);
  for (double g : with.goal) EXPECT_NEAR(g, 0, 1e-12);  // but for the rounding of the sums
}

}  // namespace
}  // namespace knotfit::test
