#include "knotfit/fit_least_squares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/threads.h"
#include "support/dense_reference.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

LeastSquaresResult solved(const ParameterizedPoints& points, const KnotVector& u, const KnotVector& v,
                          const LeastSquaresOptions& options = {}) {
  LeastSquaresResult result = fit_least_squares(points, u, v, options);
  EXPECT_EQ(result.status, FitStatus::solved);
  for (double x : result.surface.net()) EXPECT_TRUE(std::isfinite(x));
  return result;
}

/// Largest difference of two nets.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  return most;
}

/// Data taken from a random surface on these knots, and the largest error of its fit.
LeastSquaresResult refit(Random& random, const KnotVector& u, const KnotVector& v, int dimension,
                         bool weighted, int steps) {
  const Surface s(u, v, dimension, random_numbers(random, u.size() * v.size() * dimension));
  ParameterizedPoints points = random_points(random, 20 * u.size() * v.size(), dimension, weighted);
  points.values = evaluate(s, points.uv);
  LeastSquaresOptions options;
  options.refinement_steps = steps;
  return solved(points, u, v, options);
}

TEST(LeastSquares, ReproducesEverySplineOfItsSpace) {
  Random random;
  for (int k = 0; k < 60; ++k) {
    const int m = random.integer(1, 4), n = random.integer(1, 4);
    const KnotVector u = KnotVector::uniform(m, random.integer(0, 9));
    const KnotVector v = KnotVector::uniform(n, random.integer(0, 9));
    const LeastSquaresResult result = refit(random, u, v, random.integer(1, 3), k % 2 == 0, 1);
    EXPECT_LE(result.error.max, 64 * (m + n) * kEps * std::sqrt(result.condition))
        << "degree " << m << "x" << n << ", condition " << result.condition;
  }
}

TEST(LeastSquares, ReproducesSplinesOfAnyDegreeOnUnequalKnotsInMoreSteps) {
  // Short spans and high degrees leave the floor a larger share: each step multiplies by it once more.
  Random random;
  for (int k = 0; k < 60; ++k) {
    const int m = random.integer(1, kMaxDegree), n = random.integer(1, kMaxDegree);
    const KnotVector u = KnotVector::clamped(m, random_interior(random, random.integer(0, 5)));
    const KnotVector v = KnotVector::clamped(n, random_interior(random, random.integer(0, 5)));
    const LeastSquaresResult result = refit(random, u, v, random.integer(1, 3), k % 2 == 0, 10);
    EXPECT_LE(result.error.max, 64 * (m + n) * kEps * std::sqrt(result.condition))
        << "degree " << m << "x" << n << ", condition " << result.condition;
  }
}

TEST(LeastSquares, RefinementTakesTheFloorsShareToRounding) {
  Random random;
  const KnotVector knots = KnotVector::uniform(3, 8);
  const Surface s(knots, knots, 1, random_numbers(random, knots.size() * knots.size()));
  ParameterizedPoints points = random_points(random, 5000, 1);
  points.values = evaluate(s, points.uv);
  LeastSquaresOptions plain;
  plain.refinement_steps = 0;
  const double before = solved(points, knots, knots, plain).error.max;
  EXPECT_GT(before, 1e-10);  // about 4e-8 [METHOD 1.2]
  EXPECT_LT(before, 1e-6);
  EXPECT_LT(solved(points, knots, knots).error.max, 1e-13);
}

TEST(LeastSquares, GradientOfTheFunctionalVanishes) {
  Random random;
  for (int k = 0; k < 10; ++k) {
    const int m = random.integer(1, 5), n = random.integer(1, 5), dimension = random.integer(1, 3);
    const KnotVector u = KnotVector::clamped(m, random_interior(random, 4));
    const KnotVector v = KnotVector::clamped(n, random_interior(random, 5));
    const ParameterizedPoints points = random_points(random, 900, dimension, true);
    LeastSquaresOptions options;
    options.refinement_steps = 0;
    options.smoothing = k % 2 == 0 ? 1e-9 : 1e-4;
    const LeastSquaresResult result = solved(points, u, v, options);
    const DenseProblem dense(points, u, v, options.smoothing);
    EXPECT_NEAR(result.smoothing, dense.lambda, 1e-9 * dense.lambda);
    const Eigen::MatrixXd c = as_matrix(result.surface.net(), dimension);
    const Eigen::MatrixXd r = dense.a * c - dense.data;
    const Eigen::MatrixXd gradient =
        dense.a.transpose() * dense.w.asDiagonal() * r + dense.lambda * dense.energy * c;
    const double scale = (dense.a.transpose() * dense.w).maxCoeff() * (1 + c.cwiseAbs().maxCoeff());
    EXPECT_LE(gradient.cwiseAbs().maxCoeff(), 1000 * (m + n) * kEps * scale) << m << "x" << n;
  }
}

TEST(LeastSquares, OneRefinementStepIsThatOfTheMethod) {
  Random random;
  const KnotVector u = KnotVector::clamped(3, random_interior(random, 4)), v = KnotVector::uniform(2, 5);
  const ParameterizedPoints points = random_points(random, 900, 2, true);
  LeastSquaresOptions options;
  options.smoothing = 1e-3;  // so that the step is large
  options.refinement_steps = 1;
  const DenseProblem dense(points, u, v, options.smoothing);
  const Eigen::LDLT<Eigen::MatrixXd> g(dense.g);
  Eigen::MatrixXd c = g.solve(dense.rhs);
  c -= g.solve(dense.a.transpose() * dense.w.asDiagonal() * (dense.a * c - dense.data));
  const Eigen::MatrixXd net = as_matrix(solved(points, u, v, options).surface.net(), 2);
  EXPECT_LE((net - c).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(LeastSquares, AnIntegerWeightIsARepeatedPoint) {
  Random random;
  ParameterizedPoints weighted = random_points(random, 400, 2), repeated = weighted;
  for (Index k = 0; k < 400; ++k) {
    const int weight = random.integer(1, 4);
    weighted.weights.push_back(weight);
    for (int copy = 1; copy < weight; ++copy) {
      repeated.uv.insert(repeated.uv.end(), {weighted.u(k), weighted.v(k)});
      repeated.values.insert(repeated.values.end(), {weighted.value(k)[0], weighted.value(k)[1]});
    }
  }
  const KnotVector u = KnotVector::uniform(3, 3), v = KnotVector::uniform(2, 4);
  EXPECT_LE(difference(solved(weighted, u, v).surface.net(), solved(repeated, u, v).surface.net()), 1e-11);
}

TEST(LeastSquares, AHeavyPointIsApproached) {
  Random random;
  ParameterizedPoints points = random_points(random, 500, 1);
  points.weights.assign(500, 1.0);
  points.weights[123] = 1e6;
  const KnotVector knots = KnotVector::uniform(3, 3);
  EXPECT_LT(solved(points, knots, knots).errors[123], 1e-3);
}

TEST(LeastSquares, HolesAndEmptyCellsDoNotBreakIt) {
  Random random;
  for (int k = 0; k < 40; ++k) {
    // Where a knot leaves less than C1 (C0 for the membrane), the energy does not see the bend.
    const int m = random.integer(1, 6), n = random.integer(1, 6);
    const KnotVector u = KnotVector::clamped(m, random_interior(random, 12, std::max(1, m - 1)));
    const KnotVector v = KnotVector::clamped(n, random_interior(random, 12, std::max(1, n - 1)));
    ParameterizedPoints points = random_points(random, 2 * u.size() * v.size(), 1, k % 2 == 0);
    for (Index i = 0; i < points.size(); ++i) {
      double &a = points.uv[2 * i], &b = points.uv[2 * i + 1];
      if (k % 4 == 0) a *= 0.3;                                            // an empty side
      if (k % 4 == 1) a = a < 0.5 ? a / 3 : 1 - (1 - a) / 3;               // a gap
      if (k % 4 == 2) b = std::clamp(a + (b - 0.5) / 10, 0.0, 1.0);        // a band along the diagonal
      if (k % 4 == 3 && std::hypot(a - 0.5, b - 0.5) < 0.3) a = b = 0.99;  // a hole and a heap
      points.values[i] = franke(a, b);
    }
    const LeastSquaresResult result = solved(points, u, v);
    EXPECT_GT(result.empty_cells, 0);
    EXPECT_LT(result.error.max, 1.3);  // the data's range
    EXPECT_LT(result.surface.scale(), 1e4);
  }
}

TEST(LeastSquares, SaysSingularWhereNothingTellsTheSurfaceApart) {
  // No data beyond the jump, and no energy holds what it cuts off: a plane fits there as well as any.
  Random random;
  ParameterizedPoints points = random_points(random, 600, 1);
  for (Index k = 0; k < 600; ++k) points.uv[2 * k] /= 2;
  const KnotVector jump = KnotVector::clamped(3, std::vector{0.75, 0.75, 0.75, 0.75}),
                   v = KnotVector::uniform(3, 2);
  const LeastSquaresResult result = fit_least_squares(points, jump, v);
  EXPECT_EQ(result.status, FitStatus::singular);
  EXPECT_TRUE(result.surface.empty());
  EXPECT_TRUE(result.errors.empty());
}

TEST(LeastSquares, CountsTheCellsWithoutPoints) {
  ParameterizedPoints points;
  Random random;
  const KnotVector knots = KnotVector::clamped(3, std::vector{0.25, 0.5, 0.5, 0.75});
  for (int k = 0; k < 100; ++k) {
    points.uv.insert(points.uv.end(), {random.uniform(0, 0.25), random.unit()});
    points.values.push_back(1);
  }
  const LeastSquaresResult result = solved(points, knots, knots);
  EXPECT_EQ(result.empty_cells, 12);  // spans of no length are no cells
  EXPECT_NEAR(result.error.max, 0, 1e-9);
}

TEST(LeastSquares, WithoutAFloorOneIsRaisedWhereCellsAreEmpty) {
  Random random;
  ParameterizedPoints points = random_points(random, 500, 1);
  for (double& x : points.uv) x /= 2;
  const KnotVector knots = KnotVector::uniform(3, 9);
  LeastSquaresOptions options;
  options.smoothing = 0;
  const LeastSquaresResult result = solved(points, knots, knots, options);
  EXPECT_GT(result.smoothing, 0);  // and said
  EXPECT_EQ(solved(random_points(random, 500, 1), KnotVector(3, {0, 0, 0, 0, 1, 1, 1, 1}),
                   KnotVector(3, {0, 0, 0, 0, 1, 1, 1, 1}), options)
                .smoothing,
            0);
}

TEST(LeastSquares, AnyFloorAskedForIsUsed) {
  Random random;
  const ParameterizedPoints points = random_points(random, 500, 1);
  const KnotVector knots = KnotVector::uniform(3, 4);
  double energy = std::numeric_limits<double>::infinity();
  for (double smoothing : {1e-6, 1e-3, 1.0, 100.0}) {
    LeastSquaresOptions options;
    options.smoothing = smoothing;
    options.refinement_steps = 0;
    const LeastSquaresResult result = solved(points, knots, knots, options);
    const DenseProblem dense(points, knots, knots, smoothing);
    EXPECT_NEAR(result.smoothing, dense.lambda, 1e-9 * dense.lambda);
    const Eigen::MatrixXd c = as_matrix(result.surface.net(), 1);
    const double now = (c.transpose() * dense.energy * c).value();
    EXPECT_LT(now, energy);  // more smoothing, less energy
    energy = now;
  }
}

TEST(LeastSquares, TheFloorGoesWithTheScaleOfTheData) {
  Random random;
  const ParameterizedPoints points = random_points(random, 800, 2, true);
  const KnotVector u = KnotVector::clamped(3, random_interior(random, 5)), v = KnotVector::uniform(3, 4);
  const std::vector<double> net = solved(points, u, v).surface.net();
  for (int power : {-200, -30, 40, 300}) {  // exact in binary: the same bits
    ParameterizedPoints scaled = points;
    for (double& x : scaled.values) x = std::ldexp(x, power);
    const std::vector<double> big = solved(scaled, u, v).surface.net();
    for (std::size_t k = 0; k < net.size(); ++k) EXPECT_EQ(big[k], std::ldexp(net[k], power));
  }
  for (int power : {-100, 6, 100}) {  // weights: lambda goes with the trace
    ParameterizedPoints heavy = points;
    for (double& w : heavy.weights) w = std::ldexp(w, power);
    EXPECT_EQ(solved(heavy, u, v).surface.net(), net) << power;
  }
}

TEST(LeastSquares, SteepDataIsNotBiasedByTheFloor) {
  // An absolute floor held the error of this step 9 times too high [METHOD 1.2].
  ParameterizedPoints points;
  Uniform random(1);
  for (int k = 0; k < 4000; ++k) {
    const double u = random(), v = random();
    points.uv.insert(points.uv.end(), {u, v});
    points.values.push_back(std::tanh(80 * (u - 0.5)));
  }
  std::vector<double> interior;
  for (double x : {0.2, 0.4, 0.46, 0.47, 0.48, 0.49, 0.5, 0.51, 0.52, 0.53, 0.54, 0.6, 0.8})
    interior.push_back(x);
  const KnotVector u = KnotVector::clamped(3, interior), v = KnotVector::uniform(3, 1);
  const DenseProblem dense(points, u, v, 0);
  const Eigen::VectorXd c = dense.a.colPivHouseholderQr().solve(dense.data.col(0));
  const double best = (dense.a * c - dense.data).norm() / std::sqrt(4000.0);
  for (int steps : {0, 1}) {
    LeastSquaresOptions options;
    options.refinement_steps = steps;
    EXPECT_LE(solved(points, u, v, options).error.rms, best * (1 + 1e-6)) << steps << " steps";
  }
}

TEST(LeastSquares, IsTheBestOfAllSurfacesOnItsKnots) {
  Random random;
  const ParameterizedPoints points = random_points(random, 600, 1, true);
  const KnotVector knots = KnotVector::uniform(3, 4);
  const LeastSquaresResult result = solved(points, knots, knots);
  auto weighted_sum = [&](const Surface& s) {
    const std::vector<double> values = evaluate(s, points.uv);
    double sum = 0;
    for (Index k = 0; k < points.size(); ++k) sum += points.weight(k) * square(values[k] - points.values[k]);
    return sum;
  };
  const double best = weighted_sum(result.surface);
  for (int k = 0; k < 100; ++k) {
    std::vector<double> net = result.surface.net();
    const double size = random.log_uniform(1e-5, 1);
    for (double& x : net) x += size * random.uniform(-1, 1);
    EXPECT_GT(weighted_sum(Surface(knots, knots, 1, net)), best);
  }
}

TEST(LeastSquares, ErrorsAreThoseOfTheSurface) {
  Random random;
  const ParameterizedPoints points = random_points(random, 700, 3, true);
  const KnotVector u = KnotVector::clamped(3, std::vector{0.2, 0.5, 0.5, 0.5, 0.5}),
                   v = KnotVector::uniform(2, 3);
  const LeastSquaresResult result = solved(points, u, v);
  const std::vector<double> values = evaluate(result.surface, points.uv);
  ASSERT_EQ(result.errors.size(), 700u);
  for (Index k = 0; k < 700; ++k) {
    double sum = 0;
    for (int d = 0; d < 3; ++d) sum += square(values[3 * k + d] - points.value(k)[d]);
    EXPECT_NEAR(result.errors[k], std::sqrt(sum), 256 * kEps * (1 + result.surface.scale()));
  }
  EXPECT_EQ(result.error.max, result.errors[result.error.worst]);
}

TEST(LeastSquares, PointsOnAJumpBelongToTheRight) {
  // A knot of multiplicity degree + 1 at a parameter that points share: fit, errors and evaluation
  // must take the same side.
  Random random;
  for (double jump : {0.1, 0.3, 0.7, 1.0 / 3, 0.9}) {
    const KnotVector u = KnotVector::clamped(2, std::vector{0.013, jump, jump, jump}),
                     v = KnotVector::uniform(2, 1);
    const Surface s(u, v, 1, random_numbers(random, u.size() * v.size()));
    ParameterizedPoints points = random_points(random, 1500, 1);
    for (Index k = 0; k < 300; ++k) points.uv[2 * k] = jump;
    points.values = evaluate(s, points.uv);
    EXPECT_LT(solved(points, u, v).error.max, 1e-10) << jump;  // any other side is off by the jump
  }
}

TEST(LeastSquares, TransposingTheDataTransposesTheNet) {
  Random random;
  for (const auto& [m, n] : {std::pair{3, 3}, {2, 5}}) {
    const ParameterizedPoints points = random_points(random, 900, 2, true);
    ParameterizedPoints turned = points;
    for (Index k = 0; k < points.size(); ++k) std::swap(turned.uv[2 * k], turned.uv[2 * k + 1]);
    const KnotVector u = KnotVector::clamped(m, random_interior(random, 6));
    const KnotVector v = KnotVector::clamped(n, random_interior(random, 3));
    const Surface a = transposed(solved(points, u, v).surface), b = solved(turned, v, u).surface;
    EXPECT_LE(difference(a.net(), b.net()), 1e-11);
  }
}

TEST(LeastSquares, SameBitsForAnyNumberOfThreads) {
  Random random;
  const ParameterizedPoints points = random_points(random, 30000, 3, true);
  const KnotVector u = KnotVector::uniform(3, 20), v = KnotVector::uniform(2, 15);
  std::vector<double> net, errors;
  double condition = 0;
  for (int threads : {1, 2, 4}) {
    set_thread_count(threads);
    const LeastSquaresResult result = solved(points, u, v);
    if (threads == 1) {
      net = result.surface.net();
      errors = result.errors;
      condition = result.condition;
    }
    EXPECT_EQ(result.surface.net(), net);
    EXPECT_EQ(result.errors, errors);
    EXPECT_EQ(result.condition, condition);
  }
  set_thread_count(0);
}

TEST(LeastSquares, ConditionIsThatOfTheNormalMatrix) {
  Random random;
  const ParameterizedPoints points = random_points(random, 600, 1, true);
  const KnotVector u = KnotVector::uniform(3, 4), v = KnotVector::uniform(2, 5);
  const DenseProblem dense(points, u, v, 1e-9);
  auto norm = [](const Eigen::MatrixXd& m) { return m.cwiseAbs().colwise().sum().maxCoeff(); };
  const double expected = norm(dense.g) * norm(dense.g.inverse());
  const double condition = solved(points, u, v).condition;
  EXPECT_LE(condition, expected * 1.001);
  EXPECT_GE(condition, expected / 10);
  LeastSquaresOptions quick;
  quick.estimate_condition = false;
  EXPECT_EQ(solved(points, u, v, quick).condition, 0);
}

TEST(LeastSquares, RefusesKnotsThatAreNotClampedOnTheUnitInterval) {
  Random random;
  const ParameterizedPoints points = random_points(random, 100, 1);
  const KnotVector good = KnotVector::uniform(3, 1);
  for (const KnotVector& bad : {KnotVector::uniform(3, 1, 0, 2), KnotVector::uniform(3, 1, -1, 1),
                                KnotVector(1, {0, 0.2, 0.6, 1}), KnotVector()}) {
    expect_throw<InvalidInput>([&] { fit_least_squares(points, bad, good); },
                               "a fit needs clamped knot vectors on [0,1]");
    expect_throw<InvalidInput>([&] { fit_least_squares(points, good, bad); },
                               "a fit needs clamped knot vectors on [0,1]");
  }
}

TEST(LeastSquares, RefusesFewerPointsThanControlPoints) {
  Random random;
  const KnotVector knots = KnotVector::uniform(3, 1);
  expect_throw<InvalidInput>([&] { fit_least_squares(random_points(random, 24, 1), knots, knots); },
                             "24 points are fewer than 5 x 5 = 25 control points");
  expect_throw<InvalidInput>([&] { fit_least_squares(random_points(random, 24, 1), knots, knots); },
                             "ask for fewer control points or a lower `degree`");
  solved(random_points(random, 25, 1), knots, knots);
}

TEST(LeastSquares, RefusesBadPoints) {
  Random random;
  ParameterizedPoints points = random_points(random, 100, 1);
  points.uv[10] = 2;
  const KnotVector knots = KnotVector::uniform(3, 1);
  expect_throw<InvalidInput>([&] { fit_least_squares(points, knots, knots); }, "point 5 has parameters (2,");
}

}  // namespace
}  // namespace knotfit::test
