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
