#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "knotfit/place.h"
#include "place/shares.h"
#include "support/random_splines.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(QuantileMethod, LeavesAsManyPointsInEveryStrip) {
  ParameterizedPoints points = synthetic_points("franke", 3000);
  for (Index k = 0; k < points.size(); ++k) points.uv[2 * k] = square(points.u(k));
  const Placement placement = place_knots("quantile", points);
  for (int axis : {0, 1}) {
    const std::vector<double> breaks = with_ends(axis == 0 ? placement.knots.u : placement.knots.v);
    for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
      Index count = 0;
      for (Index k = 0; k < points.size(); ++k) {
        const double x = points.uv[2 * k + axis];
        count += x >= breaks[s] && x < breaks[s + 1];
      }
      EXPECT_NEAR(static_cast<double>(count), 3000 / 9.0, 2);
    }
  }
}

}  // namespace
}  // namespace knotfit::test
