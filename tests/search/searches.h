// What the tests of both routes to a tolerance share.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "knotfit/evaluate.h"
#include "knotfit/refine.h"
#include "support/synthetic.h"
namespace knotfit::test {

inline RefineOptions to_max_error(double tolerance, const std::string& method = "error-model") {
  RefineOptions options;
  options.tolerance.value = tolerance;
  options.method = method;
  return options;
}

inline RefineOptions by_insertion(double tolerance) {
  RefineOptions options = to_max_error(tolerance);
  options.route = RefineRoute::insert;
  return options;
}

/// The error that counts of the surface handed out, by evaluation at the points.
inline double evaluated_error(const Surface& s, const ParameterizedPoints& points,
                              const Tolerance& tolerance) {
  const std::vector<double> values = evaluate(s, points.uv);
  std::vector<double> errors;
  for (Index k = 0; k < points.size(); ++k) {
    double sum = 0;
    for (int d = 0; d < points.dimension; ++d)
      sum += square(values[k * points.dimension + d] - points.value(k)[d]);
    errors.push_back(std::sqrt(sum));
  }
  return measured_error(errors, tolerance);
}

inline Index control_points(const RefineResult& r) {
  return r.surface.control_point_count();
}

/// What every result must be, whatever its status: a finite surface on the knots reported, with the
/// error reported, and a list of what was tried that agrees with it.
inline void expect_consistent(const RefineResult& r, const ParameterizedPoints& points,
                              const RefineOptions& o) {
  ASSERT_NE(r.status, Status::not_run);
  ASSERT_FALSE(r.surface.empty());
  for (double x : r.surface.net()) ASSERT_TRUE(std::isfinite(x));
  EXPECT_EQ(r.surface.knots_u().interior(), r.knots.u);
  EXPECT_EQ(r.surface.knots_v().interior(), r.knots.v);
  EXPECT_EQ(r.surface.degree_u(), o.degree_u);
  EXPECT_EQ(r.surface.degree_v(), o.degree_v);
  ASSERT_TRUE(std::isfinite(r.error));
  const double scale = r.surface.scale() + 1;
  EXPECT_NEAR(evaluated_error(r.surface, points, o.tolerance), r.error, 1e-11 * scale);
  if (r.status == Status::reached) {
    EXPECT_LE(r.error, o.tolerance.value);
  }
  EXPECT_GT(r.fits, 0);
  ASSERT_FALSE(r.tried.empty());
  bool listed = false;
  for (const SizeTried& t : r.tried) {
    EXPECT_EQ(t.holds, t.error <= o.tolerance.value);
    listed = listed || (t.size_u == r.surface.size_u() && t.size_v == r.surface.size_v());
  }
  EXPECT_TRUE(listed);
}

}  // namespace knotfit::test
