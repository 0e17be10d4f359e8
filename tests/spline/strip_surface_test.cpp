#include "spline/strip_surface.h"

#include <gtest/gtest.h>

#include "knotfit/curve.h"
#include "knotfit/evaluate.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

Curve random_curve(Random& random, int degree, int dimension) {
  const KnotVector knots = KnotVector::clamped(degree, std::vector<double>{0.2, 0.5, 0.9});
  std::vector<double> net;
  for (Index i = 0; i < knots.size() * dimension; ++i) net.push_back(random.uniform(-1, 1));
  return Curve(knots, dimension, std::move(net));
}

TEST(StripSurface, IsTheCurveAtEveryV) {
  Random random;
  for (int dimension : {1, 2, 3}) {
    const Curve curve = random_curve(random, 3, dimension);
    const Surface strip = strip_surface(curve, 3);
    ASSERT_EQ(strip.dimension(), 3);
    for (double t : {0.0, 0.37, 0.5, 1.0})
      for (double v : {0.0, 0.6, 1.0}) {
        const std::vector<double> at = evaluate(curve, std::vector<double>{t});
        double p[3];
        evaluate(strip, t, v, p);
        for (int e = 0; e < 3; ++e) EXPECT_NEAR(p[e], e < dimension ? at[e] : 0, 1e-14);
      }
  }
}

TEST(StripSurface, GivesTheCurveBack) {
  Random random;
  const Curve curve = random_curve(random, 2, 2);
  const Curve back = curve_of_strip(strip_surface(curve), false);
  EXPECT_EQ(back.knots(), curve.knots());
  EXPECT_EQ(back.control_points(), curve.control_points());
}

TEST(StripSurface, ClosesToTheLastBit) {
  Random random;
  const Curve closed = curve_of_strip(strip_surface(random_curve(random, 3, 2)), true);
  for (int e = 0; e < 2; ++e)
    EXPECT_EQ(closed.control_points()[e], closed.control_points()[closed.control_points().size() - 2 + e]);
}

}  // namespace
}  // namespace knotfit::test
