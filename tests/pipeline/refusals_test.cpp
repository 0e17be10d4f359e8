#include <gtest/gtest.h>

#include "knotfit/exceptions.h"
#include "pipeline/fits.h"
#include "pipeline/refused.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

TEST(Refusals, BadPoints) {
  ParameterizedPoints points = synthetic_points("franke", 200);
  points.values[3] = kNan;
  points.source.assign(200, 0);
  points.source[3] = 77;
  expect_refused(points, to_tolerance(1e-2), "point 3 (line 77) has a value that is not finite");
  points = synthetic_points("franke", 200);
  points.weights.assign(200, 1);
  points.weights[9] = 0;
  expect_refused(points, to_tolerance(1e-2), "point 9 has weight 0: weights must be positive and finite");
  points = synthetic_points("franke", 200);
  points.uv[1] = 1.5;
  expect_refused(points, to_tolerance(1e-2), "outside [0,1]; rescale the parameters");
  expect_refused({}, to_tolerance(1e-2), "no points to fit");
}

TEST(Refusals, KnotsThatAreNone) {
  const ParameterizedPoints points = synthetic_points("franke", 200);
  FitOptions options = to_tolerance(1e-2);
  options.knots = InteriorKnots{{0.5}, {1.0}};
  expect_refused(points, options, "interior knot 0 (1) is not inside (0, 1)");
  options.knots = InteriorKnots{{0.5, 0.4}, {}};
  expect_refused(points, options, "sort the knots");
  options.knots = InteriorKnots{{kNan}, {}};
  expect_refused(points, options, "interior knot 0 (nan)");
  options.knots = InteriorKnots{{0.5, 0.5, 0.5, 0.5, 0.5}, {}};
  expect_refused(points, options, "multiplicity above degree + 1");
}

TEST(Refusals, MethodsLimitsAndMaps) {
  const ParameterizedPoints points = synthetic_points("franke", 200);
  FitOptions options = to_tolerance(1e-2);
  options.method = "best";
  expect_refused(points, options, "there is no placement method 'best'; there are ");
  options.control_points_u = options.control_points_v = 6;
  expect_refused(points, options, "there is no placement method 'best'");
  options = to_tolerance(1e-2);
  options.max_control_points = 3;
  expect_refused(points, options, "at most 3 control points are fewer than the 16");
  options = to_tolerance(1e-2);
  options.max_fits = -3;
  expect_refused(points, options, "the number of fits allowed is negative");
  options = to_tolerance(1e-2);
  options.smoothing = -1;
  expect_refused(points, options, "the smoothing floor must be finite and at least 0");
  options = to_tolerance(1e-2);
  options.user_features = FeatureMap{2, 1, {1, kNan}};
  expect_refused(points, options, "the feature measure of cell (1, 0) is nan");
}

}  // namespace
}  // namespace knotfit::test
