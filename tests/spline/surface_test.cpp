#include "knotfit/surface.h"

#include <gtest/gtest.h>

#include <limits>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
#include "support/sampling.h"
namespace knotfit::test {
namespace {

using Numbers = std::vector<double>;

TEST(Surface, NamesWhatIsWrongWithItsNet) {
  const KnotVector u = KnotVector::uniform(2, 0), v = KnotVector::uniform(1, 1);
  expect_throw<InvalidInput>([&] { Surface(u, v, 2, Numbers(17)); },
                             "the control net has 17 numbers; 3 x 3 control points of dimension 2 need 18");
  expect_throw<InvalidInput>([&] { Surface(u, v, 0, {}); }, "a surface's dimension is 0");
  expect_throw<InvalidInput>([&] { Surface(KnotVector(), v, 1, {}); }, "one of them is empty");
  Numbers net(18, 1.0);
  net[11] = std::numeric_limits<double>::infinity();
  expect_throw<InvalidInput>([&] { Surface(u, v, 2, net); }, "control point (1, 2) has the coordinate inf");
}

TEST(Surface, HasTheScaleOfItsLargestCoordinate) {
  const KnotVector t = KnotVector::uniform(1, 0);
  EXPECT_EQ(Surface(t, t, 1, {1, -7, 3, 0}).scale(), 7);
  EXPECT_EQ(Surface().scale(), 0);
  EXPECT_TRUE(Surface().empty());
}

TEST(Surface, TransposedHasItsParametersExchanged) {
  Random random;
  for (const Surface& s : random_surfaces(seed(), 50)) {
    const Surface t = transposed(s);
    EXPECT_EQ(transposed(t), s);
    const double u = random_parameter(random, s.knots_u()), v = random_parameter(random, s.knots_v());
    Numbers a(static_cast<std::size_t>(s.dimension())), b = a;
    evaluate(s, u, v, a);
    evaluate(t, v, u, b);
    for (std::size_t d = 0; d < a.size(); ++d) EXPECT_NEAR(a[d], b[d], 2 * evaluation_error(s));
  }
  EXPECT_TRUE(transposed(Surface()).empty());
}

TEST(HeightFieldInSpace, HasExactPlacesAndTheSameHeights) {
  Random random;
  for (int k = 0; k < 100; ++k) {
    const int p = random.integer(1, kMaxDegree), q = random.integer(1, kMaxDegree);
    Numbers interior_u = random_numbers(random, random.integer(0, 8)), interior_v = random_numbers(random, 3);
    for (Numbers* interior : {&interior_u, &interior_v}) {
      for (double& x : *interior) x = 0.5 + 0.49 * x;
      std::sort(interior->begin(), interior->end());
    }
    const KnotVector ku = KnotVector::clamped(p, interior_u), kv = KnotVector::clamped(q, interior_v);
    const Surface height(ku, kv, 1, random_numbers(random, ku.size() * kv.size(), 100));
    const double x0 = random.uniform(-1e6, 1e6), x1 = x0 + random.uniform(1, 1e3);
    const double y0 = random.uniform(-1, 1), y1 = y0 - random.uniform(1, 2);  // y may fall
    const Surface s = height_field_in_space(height, x0, x1, y0, y1);
    // Control points: 4 eps for the mean and 2 for the interpolation; then the evaluation.
    const double places = 6 * kEps + (p + q + 2) * 4 * kEps;
    for (int l = 0; l < 50; ++l) {
      const double u = random.unit(), v = random.unit();
      Numbers point(3), z(1);
      evaluate(s, u, v, point);
      evaluate(height, u, v, z);
      EXPECT_NEAR(point[0], x0 + u * (x1 - x0), places * std::max(std::abs(x0), std::abs(x1)));
      EXPECT_NEAR(point[1], y0 + v * (y1 - y0), places * std::max(std::abs(y0), std::abs(y1)));
      EXPECT_EQ(point[2], z[0]);
    }
    Numbers corner(3);
    evaluate(s, 1, 1, corner);
    EXPECT_EQ(corner[0], x1);
    EXPECT_EQ(corner[1], y1);
  }
}

TEST(HeightFieldInSpace, NamesWhatIsWrong) {
  const KnotVector t = KnotVector::uniform(1, 0);
  expect_throw<InvalidInput>([&] { height_field_in_space(Surface(t, t, 2, Numbers(8, 1.0)), 0, 1, 0, 1); },
                             "a height field has dimension 1, not 2");
  expect_throw<InvalidInput>(
      [&] { height_field_in_space(Surface(t, t, 1, Numbers(4, 1.0)), 0, std::nan(""), 0, 1); },
      "must be finite");
  expect_throw<InvalidInput>([&] { height_field_in_space(Surface(), 0, 1, 0, 1); },
                             "the height field is empty");
}

}  // namespace
}  // namespace knotfit::test
