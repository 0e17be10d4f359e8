#include "verify/de_boor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "spline/reference.h"
#include "support/random_splines.h"
namespace knotfit::verify {
namespace {

using namespace knotfit::test;

TEST(DeBoor, IsTheSurfaceByTheDefinitionOfItsBasis) {
  Random random;
  for (const Surface& s : random_surfaces(seed(), 60))
    for (int k = 0; k < 10; ++k) {
      const double u = random_parameter(random, s.knots_u()), v = random_parameter(random, s.knots_v());
      std::vector<double> value(static_cast<std::size_t>(s.dimension()));
      de_boor(s, u, v, value);
      const std::vector<Long> expected = reference_value(s, u, v);
      // Affine combinations: a few roundings a round of either direction.
      for (std::size_t d = 0; d < value.size(); ++d)
        EXPECT_NEAR(value[d], static_cast<double>(expected[d]),
                    8 * (s.degree_u() + s.degree_v() + 2) * kEps * s.scale());
    }
}

TEST(DeBoor, ReproducesAConstant) {
  const KnotVector knots = KnotVector::clamped(4, std::vector{0.3, 0.3, 0.8});
  for (const double x : {-1.0, 0.0, 0.3, 0.55, 1.0, 2.0}) {  // what is outside counts as the end
    const Triangle triangle(knots, x);
    std::vector<double> c(5, 7.0);
    EXPECT_NEAR(triangle.value(c.data()), 7, 1e-14) << x;
    EXPECT_LE(triangle.first() + 5, knots.size());
  }
}

TEST(Distance, NeitherOverflowsNorUnderflows) {
  const std::vector<double> none = {0, 0}, huge = {3e200, 4e200}, tiny = {3e-200, 4e-200};
  EXPECT_NEAR(distance(huge, none) / 5e200, 1, 1e-15);
  EXPECT_NEAR(distance(tiny, none) / 5e-200, 1, 1e-15);
  EXPECT_EQ(distance(huge, huge), 0);
}

}  // namespace
}  // namespace knotfit::verify
