// The result goes with the data: moved, scaled, huge, tiny.
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/fits.h"
namespace knotfit::test {
namespace {

ParameterizedPoints mapped(const ParameterizedPoints& points, double scale, double offset) {
  ParameterizedPoints result = points;
  for (double& x : result.values) x = x * scale + offset;
  return result;
}

TEST(Pipeline, ScalingByPowersOfTwoScalesEveryBit) {
  const ParameterizedPoints points = synthetic_points("torus", 2000);
  FitOptions options = to_tolerance(0.02);
  options.between = true;
  const FitResult one = fit_surface(points, options);
  for (int power : {-40, 27, -300, 300}) {
    options.tolerance->value = std::ldexp(0.02, power);
    const FitResult scaled = fit_surface(mapped(points, std::ldexp(1, power), 0), options);
    EXPECT_EQ(scaled.status, Status::reached) << power;
    EXPECT_EQ(scaled.surface.knots_u(), one.surface.knots_u());
    EXPECT_EQ(scaled.surface.knots_v(), one.surface.knots_v());
    ASSERT_EQ(scaled.surface.net().size(), one.surface.net().size());
    for (std::size_t k = 0; k < one.surface.net().size(); ++k)
      ASSERT_EQ(scaled.surface.net()[k], std::ldexp(one.surface.net()[k], power));
    EXPECT_EQ(scaled.error.max, std::ldexp(one.error.max, power));
    EXPECT_EQ(scaled.diagonal, std::ldexp(one.diagonal, power));
    EXPECT_EQ(scaled.between.between, std::ldexp(one.between.between.value(), power));
    EXPECT_EQ(scaled.fits, one.fits);
  }
}

TEST(Pipeline, TinyDataIsFittedAsWell) {
  const ParameterizedPoints points = mapped(synthetic_points("franke", 2000), 1e-12, 0);
  const FitResult r = fit_surface(points, to_tolerance(5e-15));
  EXPECT_EQ(r.status, Status::reached);
  EXPECT_LE(r.error.max, 5e-15);
  EXPECT_GT(r.error.max, 1e-16);
  expect_honest(r, points);
}

TEST(Pipeline, MovedDataKeepsItsControlPoints) {
  const ParameterizedPoints points = synthetic_points("torus", 2000);
  FitOptions options = to_tolerance(0.02);
  const FitResult here = fit_surface(points, options);
  for (double offset : {1.0, -4.6e6, 1e8}) {
    const ParameterizedPoints there = mapped(points, 1, offset);
    const FitResult moved = fit_surface(there, options);
    EXPECT_EQ(moved.status, Status::reached);
    EXPECT_EQ(moved.surface.size_u(), here.surface.size_u());
    EXPECT_EQ(moved.surface.size_v(), here.surface.size_v());
    // The data itself is rounded to ulps of the offset, and so are the control points.
    const double rounding = 16 * kEps * std::abs(offset) + 1e-9;
    EXPECT_NEAR(moved.error.max, here.error.max, rounding);
    expect_honest(moved, there);
  }
}

TEST(Pipeline, HugeCoordinatesKeepTheirMillimetres) {
  // 100 m of ground with a detail of millimetres, 1e8 from the origin in x, y and z.
  for (int dimension : {1, 3}) {
    ParameterizedPoints points = synthetic_points("franke", 4000);
    points.dimension = dimension;
    points.values.clear();
    for (Index k = 0; k < points.size(); ++k) {
      const double u = points.u(k), v = points.v(k);
      if (dimension == 3) points.values.insert(points.values.end(), {1e8 + 100 * u, -1e8 + 100 * v});
      points.values.push_back(1e8 + 10 * u * v + 0.02 * std::sin(12 * u) * std::cos(9 * v));
    }
    const FitResult r = fit_surface(points, to_tolerance(1e-3));
    EXPECT_EQ(r.status, Status::reached) << r.message;
    EXPECT_LE(r.error.max, 1e-3);
    expect_honest(r, points);
    // The detail is in the surface, not smoothed away: a plane patch would be off by 0.02.
    EXPECT_GT(r.surface.control_point_count(), 16);
    const FitResult fine = fit_surface(points, to_tolerance(2e-6));  // 100 roundings of 1e8
    EXPECT_EQ(fine.status, Status::reached) << fine.message;
    expect_honest(fine, points);
  }
}

TEST(Pipeline, ExtremeMagnitudesAreNeverSilentlyWrong) {
  const ParameterizedPoints points = synthetic_points("torus", 1000);
  for (double scale : {1e-250, 1e-160, 1e150, 1e250}) {
    const ParameterizedPoints there = mapped(points, scale, 0);
    FitOptions options = to_tolerance(0.5);
    options.tolerance->relative = true;
    const FitResult r = fit_surface(there, options);
    EXPECT_NEAR(r.tolerance / scale, 0.005 * bounding_diagonal(points), 1e-9);
    if (r.status == Status::failed) continue;  // its own check refuses it, and says so
    EXPECT_EQ(r.status, Status::reached);
    const std::vector<double> errors = true_errors(r.surface, there);
    EXPECT_LE(*std::max_element(errors.begin(), errors.end()), r.tolerance * (1 + 1e-6));
  }
}

TEST(Pipeline, AnEqualHeightEverywhereIsOnePatch) {
  ParameterizedPoints points = synthetic_points("franke", 200);
  for (double height : {0.0, 5.0, -1e8}) {
    points.values.assign(200, height);
    const FitResult r = fit_surface(points, to_tolerance(1e-3));
    EXPECT_EQ(r.status, Status::reached);
    EXPECT_EQ(r.surface.control_point_count(), 16);
    EXPECT_LE(r.error.max, 4 * kEps * std::abs(height));
    EXPECT_EQ(r.diagonal, 0);
  }
}

}  // namespace
}  // namespace knotfit::test
