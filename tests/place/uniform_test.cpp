#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "knotfit/place.h"
#include "place/shares.h"
#include "support/random_splines.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(UniformMethod, IsUniformWhateverTheData) {
  const Placement placement = place_knots("uniform", synthetic_points("step", 300));
  EXPECT_EQ(placement.knots.u, uniform_knots(8));
  EXPECT_EQ(placement.knots.v, uniform_knots(8));
}

}  // namespace
}  // namespace knotfit::test
