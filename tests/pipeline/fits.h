// What the tests of the whole way share.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "knotfit/fit_surface.h"
#include "spline/reference.h"
#include "support/random_splines.h"
#include "support/synthetic.h"
namespace knotfit::test {

/// To an absolute tolerance by the error model: quick, and the same checks behind it.
inline FitOptions to_tolerance(double value) {
  FitOptions options;
  options.tolerance = ToleranceRequest{.value = value};
  options.method = "error-model";
  options.between = false;
  return options;
}

inline FitOptions at_size(int size_u, int size_v) {
  FitOptions options;
  options.control_points_u = size_u;
  options.control_points_v = size_v;
  options.method = "error-model";
  options.between = false;
  return options;
}

/// |S - P| of every point in long double, by the definition of the basis functions.
inline std::vector<double> true_errors(const Surface& s, const ParameterizedPoints& points) {
  std::vector<double> errors;
  for (Index k = 0; k < points.size(); ++k) {
    const std::vector<Long> value = reference_value(s, points.u(k), points.v(k));
    Long sum = 0;
    for (int d = 0; d < points.dimension; ++d)
      sum += (value[d] - points.value(k)[d]) * (value[d] - points.value(k)[d]);
    errors.push_back(static_cast<double>(std::sqrt(sum)));
  }
  return errors;
}

/// The verdict and every error of a result, held against errors of its surface in long double.
inline void expect_honest(const FitResult& r, const ParameterizedPoints& points) {
  ASSERT_NE(r.status, Status::failed) << r.message;
  const std::vector<double> errors = true_errors(r.surface, points);
  ASSERT_EQ(r.errors.size(), errors.size());
  const double rounding = 8 * (r.surface.degree_u() + r.surface.degree_v() + 2) * kEps * r.surface.scale();
  for (std::size_t k = 0; k < errors.size(); ++k)
    ASSERT_NEAR(r.errors[k], errors[k], rounding) << "point " << k;
  EXPECT_EQ(r.error.max, *std::max_element(r.errors.begin(), r.errors.end()));
  if (r.tolerance > 0) {
    EXPECT_EQ(r.measured, measured_error(r.errors, r.asked));
    EXPECT_EQ(r.reached, r.measured <= r.tolerance);
    EXPECT_EQ(r.asked.value, r.tolerance);
  }
  EXPECT_FALSE(r.message.empty());
}

}  // namespace knotfit::test
