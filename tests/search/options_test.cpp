#include <gtest/gtest.h>

#include "search/routes.h"
#include "support/synthetic.h"
namespace knotfit {
namespace {

using namespace knotfit::test;

TEST(SearchOptions, ReachThePlacementAndTheFits) {
  RefineOptions options;
  options.degree_u = 2;
  options.degree_v = 4;
  options.smoothing = 1e-4;
  options.tolerance = {0.3, ErrorMeasure::rms, 1};
  options.energy = make_data_energy(synthetic_points("franke", 50), 0.3);
  const PlacementOptions placement = placement_options(options);
  EXPECT_EQ(placement.degree_u, 2);
  EXPECT_EQ(placement.degree_v, 4);
  EXPECT_EQ(placement.smoothing, 1e-4);
  EXPECT_EQ(placement.energy, options.energy);
  const LeastSquaresOptions fits = search_fits(options);
  EXPECT_EQ(fits.smoothing, 1e-4);
  EXPECT_EQ(fits.energy, options.energy);
  EXPECT_FALSE(fits.use_grid) << "knots move";
  EXPECT_FALSE(fits.estimate_condition);
  EXPECT_EQ(fits.refinement_steps, 0);
}

}  // namespace
}  // namespace knotfit
