#include <gtest/gtest.h>

#include "clouds.h"
#include "knotfit/parameterize_cloud.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

TEST(TriangulatedParameters, StayWhereTheyAre) {
  Random random;
  Points p, uv;
  for (int k = 0; k < 400; ++k) {
    // A strip 50 times as long as wide, in the middle of the square.
    uv.push_back(0.2 + 0.5 * random.unit()), uv.push_back(0.3 + 0.6 * random.unit());
    p.insert(p.end(), {50 * uv[2 * k], uv[2 * k + 1], 0.0});
  }
  const CloudMap c = triangulate_parameters(p, uv);
  expect_sound(c);
  EXPECT_EQ(c.base, CloudBase::given);
  for (std::size_t k = 0; k < uv.size(); ++k) EXPECT_NEAR(c.map.uv[k], uv[k], 1e-7);
  EXPECT_NEAR(c.map.quality.aspect_free_stretch, 1, 1e-3);
}

}  // namespace
}  // namespace knotfit::test
