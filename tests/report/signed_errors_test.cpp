#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "scenes.h"
namespace knotfit {
namespace {

TEST(SignedErrors, ArePositiveWhereAHeightFieldLiesAboveThePoint) {
  const Surface s = scenes::heights([](double, double) { return 2.0; });
  ParameterizedPoints points;
  points.uv = {0.2, 0.3, 0.5, 0.5, 0.9, 0.1};
  points.values = {1.5, 2, 2.25};
  const std::vector<double> e = signed_errors(s, points);
  EXPECT_NEAR(e[0], 0.5, 1e-14);
  EXPECT_NEAR(e[1], 0, 1e-14);
  EXPECT_NEAR(e[2], -0.25, 1e-14);
}

TEST(SignedErrors, ArePositiveWhereTheSurfaceLiesOnItsNormalsSide) {
  const Surface s = scenes::in_space([](double u, double v) { return std::vector{u, v, 0.0}; });  // normal +z
  ParameterizedPoints points;
  points.dimension = 3;
  points.uv = {0.5, 0.5, 0.5, 0.5, 0.5, 0.5};
  points.values = {0.5, 0.5, -0.1, 0.5, 0.5, 0.1, 0.5, 0.1, 0.3};
  const std::vector<double> e = signed_errors(s, points);
  EXPECT_NEAR(e[0], 0.1, 1e-14);
  EXPECT_NEAR(e[1], -0.1, 1e-14);
  EXPECT_NEAR(e[2], -0.5, 1e-14) << "the size is the whole distance, 3-4-5";
  const std::vector<double> turned = signed_errors(transposed(s), points);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(turned[k], -e[k], 1e-14) << "u and v exchanged turn the normal";
}

TEST(SignedErrors, HaveTheSizeOfTheDistance) {
  const Surface s = scenes::in_space([](double u, double v) {
    return std::vector{u, v + 0.3 * u * u, std::sin(3 * u) * v};
  });
  ParameterizedPoints points = scenes::random_points(200, 3);
  const std::vector<double> e = signed_errors(s, points), at = evaluate(s, points.uv);
  for (Index k = 0; k < points.size(); ++k)
    EXPECT_NEAR(std::abs(e[k]), std::hypot(at[3 * k], at[3 * k + 1], at[3 * k + 2]), 1e-14);
}

TEST(SignedErrors, HaveNoSignInThePlaneOrWhereThereIsNoNormal) {
  const Surface plane = scenes::in_space([](double u, double v) { return std::vector{u, v}; });
  ParameterizedPoints points = scenes::random_points(20, 2);
  for (double e : signed_errors(plane, points)) EXPECT_GE(e, 0);
  const Surface point = scenes::in_space([](double, double) { return std::vector{1.0, 2.0, 2.0}; });
  ParameterizedPoints in_space = scenes::random_points(20, 3);
  for (double e : signed_errors(point, in_space)) EXPECT_NEAR(e, 3, 1e-13);
}

TEST(SignedErrors, TakeHugeAndTinyCoordinates) {
  for (double scale : {1e-200, 1e200}) {
    const Surface s = scenes::in_space([&](double u, double v) {
      return std::vector{scale * u, scale * v, scale};
    });
    ParameterizedPoints points = scenes::random_points(5, 3);
    for (Index k = 0; k < points.size(); ++k) {
      points.values[3 * k] = scale * points.u(k);
      points.values[3 * k + 1] = scale * points.v(k);
    }
    for (double e : signed_errors(s, points)) EXPECT_NEAR(e / scale, 1, 1e-13);
  }
}

TEST(SignedErrors, RefusePointsOfAnotherDimension) {
  const Surface s = scenes::heights(scenes::hills);
  EXPECT_THROW(signed_errors(s, scenes::random_points(5, 3)), InvalidInput);
  EXPECT_THROW(signed_errors(Surface(), scenes::random_points(5)), InvalidInput);
  ParameterizedPoints bad = scenes::random_points(5);
  bad.values.pop_back();
  EXPECT_THROW(signed_errors(s, bad), InvalidInput);
}

}  // namespace
}  // namespace knotfit
