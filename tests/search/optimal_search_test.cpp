// The size search with optimised knots [METHOD 4.2].
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "search/searches.h"
#include "support/two_threads.h"
namespace knotfit::test {
namespace {

double largest_anywhere(const std::string& name, const Surface& s) {
  std::vector<double> uv;
  for (int i = 0; i < 300; ++i)
    for (int j = 0; j < 300; ++j) uv.insert(uv.end(), {(i + 0.5) / 300, (j + 0.5) / 300});
  const std::vector<double> values = evaluate(s, uv);
  double most = 0;
  for (std::size_t k = 0; k < uv.size() / 2; ++k) {
    const std::vector<double> truth = synthetic_value(name, uv[2 * k], uv[2 * k + 1]);
    double sum = 0;
    for (std::size_t d = 0; d < truth.size(); ++d) sum += square(values[k * truth.size() + d] - truth[d]);
    most = std::max(most, std::sqrt(sum));
  }
  return most;
}

TEST(OptimalSearch, NeedsFewerControlPointsThanPlacedKnots) {
  for (const auto& [name, most] : {std::pair{"franke", 116}, {"step", 110}, {"torus", 110}}) {
    const ParameterizedPoints points = synthetic_points(name, 10000);
    const double tolerance = 1e-3 * synthetic_diagonal(points);
    const RefineResult r = refine_to_tolerance(points, to_max_error(tolerance, "optimal"));
    EXPECT_EQ(r.status, Status::reached) << name;
    EXPECT_LE(control_points(r), most) << name;
    EXPECT_LE(evaluated_error(r.surface, points, {tolerance}), tolerance) << name;
    EXPECT_GT(r.fill_points, 0) << name;
    EXPECT_LE(largest_anywhere(name, r.surface), 1.5 * tolerance) << name;
  }
}

TEST(OptimalSearch, RmsAndPercentileToo) {
  const ParameterizedPoints points = synthetic_points("franke", 10000);
  RefineOptions options = to_max_error(1e-4 * synthetic_diagonal(points), "optimal");
  options.tolerance.measure = ErrorMeasure::rms;
  const RefineResult rms = refine_to_tolerance(points, options);
  EXPECT_EQ(rms.status, Status::reached);
  EXPECT_LE(control_points(rms), 168);
  EXPECT_LE(evaluated_error(rms.surface, points, options.tolerance), options.tolerance.value);
  options.tolerance = {1e-3 * synthetic_diagonal(points), ErrorMeasure::percentile, 0.95};
  const RefineResult share = refine_to_tolerance(points, options);
  EXPECT_EQ(share.status, Status::reached);
  EXPECT_LE(evaluated_error(share.surface, points, options.tolerance), options.tolerance.value);
}

TEST(OptimalSearch, SaysEarlyWhereKnotsCannotHelp) {
  // Waves of one length all over: no knot is better placed than another.
  ParameterizedPoints points;
  Uniform uniform(3);
  for (int k = 0; k < 6000; ++k) {
    const double u = uniform(), v = uniform();
    points.uv.insert(points.uv.end(), {u, v});
    points.values.push_back(std::sin(40 * u + 9 * v) + std::cos(38 * v - 11 * u));
  }
  const RefineResult r = refine_to_tolerance(points, to_max_error(1e-2, "optimal"));
  EXPECT_EQ(r.status, Status::reached);
  ASSERT_EQ(r.notes.size(), 1u);
  EXPECT_NE(r.notes[0].find("optimised knots would save about"), std::string::npos) << r.notes[0];
  EXPECT_NE(r.notes[0].find("error model's knots"), std::string::npos)
      << r.notes[0];  // inserted lines need fewer
}

TEST(OptimalSearch, IsNotPutOffByClusters) {
  // 30 times denser at u = 0 than at u = 1: uniform knots and steps from one start say that nothing can be saved.
  ParameterizedPoints points;
  Uniform uniform(1);
  while (points.size() < 10000) {
    const double u = uniform(), v = uniform();
    if (uniform() > std::pow(30.0, -u)) continue;
    points.uv.insert(points.uv.end(), {u, v});
    points.values.push_back(ridge(u, v));
  }
  RefineOptions options = to_max_error(1e-3 * synthetic_diagonal(points), "optimal");
  options.max_fits = 100;
  const RefineResult r = refine_to_tolerance(points, options);
  EXPECT_EQ(r.method, "optimal");
  EXPECT_TRUE(r.notes.empty()) << r.notes.front();
}

TEST(OptimalSearch, SameSurfaceForOneAndTwoThreads) {
  const ParameterizedPoints points = synthetic_points("franke", 3000);
  const RefineOptions options = to_max_error(3e-3 * synthetic_diagonal(points), "optimal");
  const auto [one, two] = on_one_and_two_threads([&] { return refine_to_tolerance(points, options); });
  EXPECT_EQ(one.surface, two.surface);
  EXPECT_EQ(one.fits, two.fits);
}

}  // namespace
}  // namespace knotfit::test
