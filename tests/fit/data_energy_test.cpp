// The energy that holds a surface to its data where hardly any point does.
#include "solve/data_energy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/fit_problem.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
#include "support/two_threads.h"
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

ParameterizedPoints uneven_points(Index n, unsigned seed) {
  ParameterizedPoints points = synthetic_points("ridge", n, seed);
  for (std::size_t i = 0; i < points.uv.size(); i += 2) points.uv[i] = points.uv[i] * points.uv[i];
  return points;
}

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

TEST(DataEnergy, SameBitsForAnyNumberOfThreads) {
  const ParameterizedPoints points = uneven_points(5000, 2);
  const auto [one, two] = on_one_and_two_threads([&] {
    LeastSquaresOptions options;
    options.energy = make_data_energy(points, 0.01);
    FitProblem problem(points, 3, 3, options);
    problem.solve({{0.2, 0.21, 0.5}, {0.4, 0.6}});
    return problem.net();
  });
  EXPECT_EQ(one, two);
}

// Knots that cluster where the data has a gap: functions that hardly meet points, and least squares let them swing.
TEST(DataEnergy, HoldsFunctionsThatHardlyMeetData) {
  ParameterizedPoints points;
  Uniform random(9);
  for (int i = 0; i < 3000; ++i) {
    double u = random();
    if (u > 0.5 && u < 0.53) u += 0.05;  // no point there
    const double v = random();
    points.uv.insert(points.uv.end(), {u, v});
    points.values.push_back(std::sin(9 * u) * v + 0.02 * random.normal());
  }
  const auto energy = make_data_energy(points, 0.05);
  double without = 0, with = 0;
  for (int trial = 0; trial < 100; ++trial) {
    InteriorKnots knots{{0.25, 0.75}, {0.5}};
    for (int k = 0; k < 8; ++k) knots.u.push_back(0.495 + 0.04 * random());
    std::sort(knots.u.begin(), knots.u.end());
    auto largest = [&](const std::shared_ptr<const DataEnergy>& held) {
      LeastSquaresOptions options;
      options.energy = held;
      options.use_grid = false;
      FitProblem problem(points, 3, 3, options);
      EXPECT_TRUE(problem.solve(knots));
      double most = 0;
      std::vector<double> at(1);
      for (int i = 0; i <= 60; ++i)
        for (int j = 0; j <= 20; ++j) {
          evaluate(problem.surface(), 0.5 + 0.03 * i / 60.0, j / 20.0, at);
          most = std::max(most, std::abs(at[0]));
        }
      return most;
    };
    without = std::max(without, largest(nullptr));
    with = std::max(with, largest(energy));
  }
  EXPECT_GT(without, 5);  // the data's range is 1
  EXPECT_LT(with, 1.2);
}

// The refinement step takes the smoothing floor's share out and leaves the energy's: without a floor there is nothing to take.
TEST(DataEnergy, RefinementLeavesItsMinimum) {
  const ParameterizedPoints points = uneven_points(2000, 3);
  const InteriorKnots knots{{0.3, 0.6}, {0.2, 0.5, 0.8}};
  for (const auto& [degree_u, degree_v] : {std::pair{3, 3}, std::pair{2, 4}, std::pair{1, 3}}) {
    std::vector<double> nets[2];
    for (int steps : {0, 1}) {
      LeastSquaresOptions options;
      options.energy = make_data_energy(points, 0.05);
      options.smoothing = 0;
      options.refinement_steps = steps;
      FitProblem problem(points, degree_u, degree_v, options);
      ASSERT_TRUE(problem.solve(knots));
      nets[steps] = problem.net();
    }
    for (std::size_t i = 0; i < nets[0].size(); ++i) EXPECT_NEAR(nets[0][i], nets[1][i], 1e-9);
  }
}

TEST(DataEnergy, RefusesAScaleThatIsNone) {
  const ParameterizedPoints points = synthetic_points("franke", 100);
  for (double scale :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    expect_throw<InvalidInput>([&] { make_data_energy(points, scale); }, "positive and finite");
}

}  // namespace
}  // namespace knotfit::test
