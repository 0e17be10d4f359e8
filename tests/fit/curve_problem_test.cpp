#include "fit/curve_problem.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "knotfit/basis.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

CurvePoints random_points(Random& random, int n, int dimension, bool closed) {
  CurvePoints points;
  points.dimension = dimension;
  points.closed = closed;
  for (int k = 0; k < n; ++k) {
    points.t.push_back(random.unit());
    points.weights.push_back(random.uniform(0.5, 2));
    for (int e = 0; e < dimension; ++e) points.values.push_back(random.uniform(-1, 1));
  }
  return points;
}

/// The slow way: a dense matrix of the basis, one function at a time, and QR.
double dense_phi(const CurvePoints& points, int degree, const std::vector<double>& knots) {
  std::vector<double> all;
  const Index n = static_cast<Index>(knots.size());
  if (points.closed)
    for (int turn = -2; turn <= 2; ++turn)
      for (double x : knots) all.push_back(x + turn);
  else
    all = KnotVector::clamped(degree, knots).knots();
  const KnotVector vector(degree, all);
  const Index columns = points.closed ? n : vector.size();
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(points.size(), columns), p(points.size(), points.dimension);
  std::vector<double> basis(degree + 1);
  for (Index k = 0; k < points.size(); ++k) {
    const Index span = vector.find_span(points.t[k]);
    basis_functions(vector, span, points.t[k], basis);
    const double root = std::sqrt(points.weight(k));
    for (int i = 0; i <= degree; ++i) a(k, (span - degree + i) % columns) += root * basis[i];
    for (int e = 0; e < points.dimension; ++e) p(k, e) = root * points.value(k)[e];
  }
  return (a * a.colPivHouseholderQr().solve(p) - p).squaredNorm();
}

TEST(CurveProblem, IsLeastSquares) {
  Random random;
  for (int run = 0; run < 60; ++run) {
    const int degree = random.integer(1, 5), dimension = random.integer(1, 3);
    const bool closed = run % 2 == 1;
    const CurvePoints points = random_points(random, 120, dimension, closed);
    std::vector<double> knots;
    for (int k = 0; k < degree + 4; ++k) knots.push_back((k + random.uniform(0.2, 0.8)) / (degree + 4));
    CurveProblem problem(points, degree, 1e-13);
    ASSERT_TRUE(problem.solve(knots));
    const double expected = dense_phi(points, degree, knots);
    EXPECT_NEAR(problem.phi(), expected, 1e-9 * expected) << degree << closed;
    double sum = 0;
    const std::vector<double> errors = problem.errors();
    for (Index k = 0; k < points.size(); ++k) sum += points.weight(k) * errors[k] * errors[k];
    EXPECT_NEAR(sum, problem.phi(), 1e-12 * expected);
    // The curve is the one whose residuals these are.
    for (Index k = 0; k < points.size(); ++k) {
      const std::vector<double> c =
          evaluate(problem.curve(), std::vector<double>{problem.on_curve(points.t[k])});
      double squared = 0;
      for (int e = 0; e < dimension; ++e) squared += std::pow(c[e] - points.value(k)[e], 2);
      ASSERT_NEAR(std::sqrt(squared), errors[k], 1e-9);
    }
  }
}

TEST(CurveProblem, SurvivesSpansWithoutPoints) {
  Random random(4);
  CurvePoints points = random_points(random, 40, 2, false);
  for (double& t : points.t) t = 0.3 * t;
  CurveProblem problem(points, 3, 1e-12);
  ASSERT_TRUE(problem.solve({0.1, 0.2, 0.5, 0.6, 0.7, 0.8}));
  for (double c : problem.curve().control_points()) EXPECT_TRUE(std::isfinite(c));
}

TEST(CurveProblem, AClosedCurveNeedsEnoughKnots) {
  Random random(5);
  CurveProblem problem(random_points(random, 40, 2, true), 3, 1e-12);
  EXPECT_FALSE(problem.solve({0.1, 0.4, 0.7}));
  EXPECT_TRUE(problem.solve({0.1, 0.4, 0.7, 0.8}));
}

}  // namespace
}  // namespace knotfit::test
