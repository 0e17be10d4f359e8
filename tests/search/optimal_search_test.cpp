// The size search with optimised knots, minimax and the guard between the data [METHOD 4.2].
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "knotfit/verify.h"
#include "place/shares.h"
#include "search/cover.h"
#include "search/guard.h"
#include "search/minimax.h"
#include "search/searches.h"
#include "solve/banded_system.h"
#include "support/two_threads.h"
#include "verify/local_reference.h"
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

TEST(Minimax, LowersTheMaximumOfTheLeastSquares) {
  const ParameterizedPoints points = synthetic_points("franke", 5000);
  LeastSquaresOptions fit;
  fit.refinement_steps = 0;
  fit.estimate_condition = false;
  fit.use_grid = false;
  MovingFit problem(points, 3, 3, fit);
  const InteriorKnots knots{uniform_knots(7), uniform_knots(7)};
  problem.solve(knots);
  const double before = problem.max();
  MinimaxOptions fixed;
  fixed.move_knots = false;
  const NetState state = minimize_maximum(problem, {}, fixed);
  EXPECT_EQ(state.knots, knots);
  EXPECT_LT(state.max, 0.85 * before);
  problem.evaluate(state.knots, state.net);
  EXPECT_NEAR(problem.max(), state.max, 1e-12);
  problem.solve(knots);
  EXPECT_LT(minimize_maximum(problem, {}, {}).max, state.max);  // the knots move too
}

TEST(Minimax, EndsAtWhatIsEnough) {
  const ParameterizedPoints points = synthetic_points("franke", 3000);
  LeastSquaresOptions fit;
  fit.use_grid = false;
  MovingFit problem(points, 3, 3, fit);
  problem.solve({uniform_knots(6), uniform_knots(6)});
  MinimaxOptions options;
  options.enough = 2 * problem.max();
  const long fits = problem.fits();
  EXPECT_LE(minimize_maximum(problem, {}, options).max, options.enough);
  EXPECT_LE(problem.fits() - fits, 2);
}

TEST(Cover, LeavesNoNodeFartherThanItsRadius) {
  const ParameterizedPoints points = synthetic_points("franke", 900);
  const DistinctPoints distinct = distinct_points(points);
  const Neighbours neighbours = plain_neighbours(distinct);
  const auto places = cover_gaps(neighbours, 1, 0.5);
  EXPECT_GT(places.size(), 50u);
  EXPECT_LT(places.size(), 600u);
  for (int i = 0; i <= 120; ++i)
    for (int j = 0; j <= 120; ++j) {
      const double u = i / 120.0, v = j / 120.0;
      const bool border = i == 0 || i == 120 || j == 0 || j == 120;
      double nearest = neighbours.gap(u, v);
      for (const auto& p : places) nearest = std::min(nearest, std::hypot(p[0] - u, p[1] - v));
      EXPECT_LE(nearest, (border ? 0.5 : 1.0) / 30 + 1e-12);
    }
}

MovingFit moving(const ParameterizedPoints& points) {
  LeastSquaresOptions fit;
  fit.refinement_steps = 0;
  fit.use_grid = false;
  return MovingFit(points, 3, 3, fit);
}

TEST(Guard, FillsTheGapsThatAreWideForTheKnots) {
  const ParameterizedPoints points = synthetic_points("franke", 4000);
  const double tolerance = 1e-3 * synthetic_diagonal(points);
  JoinedPoints joined(points);
  Guard guard(joined, tolerance, 1, {uniform_knots(12), uniform_knots(12)}, {});
  EXPECT_EQ(joined.data_count(), points.size());
  EXPECT_EQ(guard.fill_count(), 0);
  MovingFit problem = moving(joined.points());
  problem.solve({uniform_knots(2), uniform_knots(2)});
  EXPECT_EQ(guard.fill(problem), 0);  // 440 points a cell: nowhere to go astray
  problem.solve({uniform_knots(24), uniform_knots(24)});
  const Index filled = guard.fill(problem);
  EXPECT_GT(filled, 200);
  EXPECT_EQ(guard.fill_count(), filled);
  EXPECT_EQ(joined.points().size(), points.size() + filled);
  problem.take_new_points();
  problem.solve({uniform_knots(24), uniform_knots(24)});
  EXPECT_EQ(guard.fill(problem), 0);  // they joined for good
  for (Index k = points.size(); k < joined.points().size(); ++k) {
    const double truth = franke(joined.points().u(k), joined.points().v(k));
    EXPECT_NEAR(joined.points().value(k)[0], truth, 4 * tolerance);
  }
}

TEST(Guard, TakesInWhereASurfaceGoesAstray) {
  const ParameterizedPoints points = synthetic_points("franke", 4000);
  const double tolerance = 1e-3 * synthetic_diagonal(points);
  JoinedPoints joined(points);
  Guard guard(joined, tolerance, 1, {uniform_knots(12), uniform_knots(12)}, {});
  MovingFit problem = moving(joined.points());
  const InteriorKnots knots{uniform_knots(24), uniform_knots(24)};
  problem.solve(knots);
  EXPECT_LE(guard.exchange(problem), 5);  // a fair fit is near the reference at most of 1 000 places
  std::vector<double> net = problem.net();
  for (double& c : net) c += 10 * tolerance;
  problem.take_new_points();
  problem.evaluate(knots, net);
  EXPECT_GT(guard.exchange(problem), 200);
}

TEST(Guard, LooksIntoASlitBetweenTwoKnots) {
  const ParameterizedPoints points = synthetic_points("franke", 4000);
  const double tolerance = 1e-3 * synthetic_diagonal(points);
  JoinedPoints joined(points);
  Guard guard(joined, tolerance, 1, {uniform_knots(12), uniform_knots(12)}, {});
  MovingFit problem = moving(joined.points());
  const InteriorKnots knots{{0.4999, 0.4999, 0.5, 0.5001, 0.5001}, {}};
  problem.solve(knots);
  std::vector<double> net = problem.net();
  const Index columns = problem.axis_v().functions();
  for (Index j = 0; j < columns; ++j) net[4 * columns + j] += 1e3 * tolerance;  // inside of the slit alone
  problem.evaluate(knots, net);
  guard.exchange(problem);
  bool inside = false;
  for (Index k = points.size(); k < joined.points().size(); ++k)
    inside |= std::abs(joined.points().u(k) - 0.5) < 1e-4;
  EXPECT_TRUE(inside);
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
