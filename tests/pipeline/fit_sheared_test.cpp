#include "knotfit/fit_sheared.h"

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "pipeline/fits.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

/// A steep front along u + a v (or v + a u).
ParameterizedPoints front(double in_u, double in_v, Index count = 3000) {
  ParameterizedPoints points;
  points.height_field = true;
  Uniform random(5);
  for (Index k = 0; k < count; ++k) {
    const double u = random(), v = random();
    points.uv.insert(points.uv.end(), {u, v});
    points.values.push_back(std::tanh(20 * (in_u * u + in_v * v - 0.6)));
  }
  return points;
}

TEST(FitSheared, FindsTheDirectionOfAFront) {
  for (const auto& [of_u, of_v, shear_u, shear_v] :
       {std::array{1.0, 0.4, 0.4, 0.0}, std::array{1.0, -0.3, -0.3, 0.0}, std::array{0.5, 1.0, 0.0, 0.5}}) {
    const Shear found = find_shear(front(of_u, of_v), FitOptions{});
    EXPECT_NEAR(found.u, shear_u, 0.051) << of_u << " u + " << of_v << " v";
    EXPECT_NEAR(found.v, shear_v, 0.051);
  }
}

TEST(FitSheared, LeavesAFrontAlongAnAxis) {
  const Shear found = find_shear(front(1, 0), FitOptions{});
  EXPECT_EQ(found.u, 0);
  EXPECT_EQ(found.v, 0);
  const ShearedFit fit = fit_sheared(front(1, 0), to_tolerance(0.01));
  EXPECT_FALSE(fit.result.map.sheared());
  EXPECT_EQ(fit.result.status, Status::reached);
}

TEST(FitSheared, NeedsFewerControlPointsAndAnswersInTheUsersPlaces) {
  const ParameterizedPoints points = front(1, 0.4);
  const FitResult plain = fit_surface(points, to_tolerance(0.01));
  const ShearedFit fit = fit_sheared(points, to_tolerance(0.01));
  const FitResult& r = fit.result;
  ASSERT_EQ(r.status, Status::reached) << r.message;
  EXPECT_TRUE(r.map.sheared());
  EXPECT_EQ(r.map, fit.points.map);
  EXPECT_LT(2 * r.surface.control_point_count(), plain.surface.control_point_count());
  expect_honest(r, fit.points);
  // At the user's own places.
  for (Index k = 0; k < points.size(); k += 50) {
    const auto [u, v] = r.map.to_uv(points.u(k), points.v(k));
    std::vector<double> z(1);
    evaluate(r.surface, u, v, z);
    EXPECT_LE(std::abs(z[0] - points.value(k)[0]), 0.01 * (1 + 1e-9));
  }
  EXPECT_NE(r.notes.back().find("oblique parameters, u +"), std::string::npos) << r.notes.back();
}

TEST(FitSheared, PromisesNothingWhereThereIsNoData) {
  FitOptions options = to_tolerance(0.01);
  options.between = true;
  const ShearedFit fit = fit_sheared(front(1, 0.4), options, Shear{.u = 0.4});
  ASSERT_TRUE(fit.result.map.sheared());
  ASSERT_TRUE(fit.result.between.measured);
  EXPECT_LT(fit.result.between.thin, 0.2);  // of the rectangle: the corners are not part of it
  for (const ThinPlace& place : fit.result.between.thin_places)
    EXPECT_TRUE(fit.result.map.covers(place.u, place.v)) << place.u << ", " << place.v;
}

TEST(FitSheared, AFixedSizeIsJudgedByTheRms) {
  const ParameterizedPoints points = front(1, 0.4);
  const ShearedFit fit = fit_sheared(points, at_size(16, 8));
  EXPECT_TRUE(fit.result.map.sheared());
  EXPECT_LT(fit.result.error.rms, fit_surface(points, at_size(16, 8)).error.rms);
}

TEST(FitSheared, AWorseShearIsLeft) {
  const ParameterizedPoints points = front(1, 0);
  const ShearedFit fit = fit_sheared(points, to_tolerance(0.01), Shear{.v = 1});
  EXPECT_FALSE(fit.result.map.sheared());
  EXPECT_EQ(fit.points.uv, points.uv);
  EXPECT_NE(fit.result.notes.back().find("tried and left"), std::string::npos);
}

TEST(FitSheared, AGivenShearOfZeroIsThePlainFitWithoutANote) {
  const ParameterizedPoints points = front(1, 0);
  const ShearedFit fit = fit_sheared(points, at_size(8, 8), Shear{});
  const FitResult plain = fit_surface(points, at_size(8, 8));
  EXPECT_EQ(fit.result.surface.net(), plain.surface.net());
  EXPECT_EQ(fit.result.notes, plain.notes);
}

TEST(FitSheared, IsForHeightFieldsOnly) {
  ParameterizedPoints points = synthetic_points("torus", 500);
  expect_throw<InvalidInput>([&] { fit_sheared(points, to_tolerance(0.1)); }, "height fields");
  points = front(1, 0.4, 500);
  expect_throw<InvalidInput>([&] { fit_sheared(points, to_tolerance(0.1), Shear{2, 0}); }, "[-1,1]");
  expect_throw<InvalidInput>([&] { fit_sheared(sheared(points, 0.2, 0), to_tolerance(0.1)); },
                             "sheared already");
}

}  // namespace
}  // namespace knotfit::test
