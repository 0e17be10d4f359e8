#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/place.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(Averaging, IsTheBooksFormula) {
  ParameterizedPoints points;
  std::vector<double> t;
  for (int k = 0; k < 50; ++k) t.push_back(square(k / 49.0));
  for (double x : t) {
    points.uv.insert(points.uv.end(), {x, std::fmod(17 * x, 1.0)});
    points.values.push_back(x);
  }
  PlacementOptions options;
  options.interior_u = 6;
  options.interior_v = 2;
  const std::vector<double> knots = place_knots("averaging", points, options).knots.u;
  const double d = 50.0 / 7;  // (N + 1)/(n - m + 1), n = 6 + 3
  for (int j = 1; j <= 6; ++j) {
    const int i = static_cast<int>(j * d);
    const double a = j * d - i;
    EXPECT_NEAR(knots[j - 1], (1 - a) * t[i - 1] + a * t[i], 1e-15);
  }
}

}  // namespace
}  // namespace knotfit::test
