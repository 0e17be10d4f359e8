#include <gtest/gtest.h>

#include "search/routes.h"
#include "solve/data_energy.h"
#include "support/synthetic.h"
namespace knotfit {
namespace {

using namespace knotfit::test;

TEST(EnergyScale, IsTheToleranceThreeTimesOneInRootMeanSquare) {
  EXPECT_EQ(energy_scale({0.5, ErrorMeasure::max, 1}), 0.5);
  EXPECT_EQ(energy_scale({0.5, ErrorMeasure::rms, 1}), 1.5);
  EXPECT_EQ(energy_scale({0.5, ErrorMeasure::percentile, 0.99}), 0.5);
}

/// The weights of an energy over the whole square.
std::vector<double> weights(const DataEnergy& energy) {
  std::vector<double> weight(DataEnergy::kKinds), goal(energy.goal_size()), scratch(energy.scratch_size());
  energy.integrate(0, 1, 0, 1, weight.data(), goal.data(), scratch.data());
  return weight;
}

TEST(OwnEnergy, HasTheErrorAsItsScaleButAtLeastTheTolerance) {
  const ParameterizedPoints points = synthetic_points("franke", 500);
  const Tolerance tolerance{0.01, ErrorMeasure::max, 1};
  EXPECT_EQ(weights(*own_energy(points, tolerance, 0.2)), weights(*make_data_energy(points, 0.2)));
  EXPECT_EQ(weights(*own_energy(points, tolerance, 0.001)), weights(*make_data_energy(points, 0.01)));
  EXPECT_NE(weights(*make_data_energy(points, 0.2)), weights(*make_data_energy(points, 0.01)));
}

}  // namespace
}  // namespace knotfit
