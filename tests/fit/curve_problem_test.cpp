#include "fit/curve_problem.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>

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

/// Points on a wave that two gaps cut, evenly spaced elsewhere.
CurvePoints wave_with_gaps(bool closed) {
  CurvePoints points;
  points.closed = closed;
  for (int k = 0; k < 200; ++k) {
    const double t = k / 200.0;
    if ((t > 0.3 && t < 0.36) || t > 0.95) continue;
    points.t.push_back(t);
    points.values.insert(points.values.end(), {std::cos(2 * M_PI * t), std::sin(2 * M_PI * t)});
  }
  return points;
}

std::shared_ptr<const DataEnergy> energy_of(const CurvePoints& points, double scale) {
  return std::make_shared<const DataEnergy>(strip_raster(points, scale));
}

// The goals are the derivatives of the data's own quadratics: what these are everywhere is not charged.
TEST(CurveProblem, TheEnergyKeepsALineAsItIs) {
  Random random(6);
  CurvePoints points;
  for (int k = 0; k < 80; ++k) {
    points.t.push_back(random.unit());
    points.values.insert(points.values.end(), {3 - 2 * points.t.back(), 5 * points.t.back()});
  }
  for (int degree : {1, 2, 3, 5}) {
    CurveProblem problem(points, degree, 1e-12, energy_of(points, 0.1));
    ASSERT_TRUE(problem.solve({0.2, 0.21, 0.5, 0.8}));
    for (double t : {0.0, 0.205, 0.33, 1.0}) {
      const std::vector<double> at = evaluate(problem.curve(), std::vector<double>{t});
      EXPECT_NEAR(at[0], 3 - 2 * t, 3e-4) << degree;
      EXPECT_NEAR(at[1], 5 * t, 3e-4) << degree;
    }
  }
}

// Knots that crowd in a gap leave functions that hardly meet data, which noise blows up; the energy holds them.
TEST(CurveProblem, TheEnergyHoldsTheCurveInGaps) {
  for (bool closed : {false, true}) {
    CurvePoints points = wave_with_gaps(closed);
    Random random(7);
    for (double& x : points.values) x += random.uniform(-0.003, 0.003);
    std::vector<double> knots;
    for (double x :
         {0.05, 0.15, 0.25, 0.2999, 0.307, 0.314, 0.321, 0.328, 0.335, 0.36, 0.45, 0.55, 0.7, 0.8, 0.9})
      knots.push_back(x);
    auto farthest = [&](std::shared_ptr<const DataEnergy> energy) {
      CurveProblem problem(points, 3, 1e-12, std::move(energy));
      EXPECT_TRUE(problem.solve(knots));
      double most = 0;
      for (int k = 0; k <= 100; ++k) {
        const double t = 0.29 + 0.08 * k / 100;
        const std::vector<double> at = evaluate(problem.curve(), std::vector<double>{problem.on_curve(t)});
        most = std::max(most, std::abs(std::hypot(at[0], at[1]) - 1));
      }
      return most;
    };
    const double plain = farthest(nullptr), held = farthest(energy_of(points, 0.01));
    EXPECT_GT(plain, 0.1) << closed;
    EXPECT_LT(held, 0.01) << closed;
  }
}

// A period begins anywhere: raster cells are as wide as the shift.
TEST(CurveProblem, TheEnergyOfAClosedCurveKnowsNoSeam) {
  const CurvePoints points = wave_with_gaps(true);
  const Index side = strip_raster(points, 0.01).side_u / 2;
  const double shift = 40.0 / static_cast<double>(side);
  CurvePoints turned = points;
  for (double& t : turned.t) t = t + shift < 1 ? t + shift : t + shift - 1;
  const std::vector<double> knots = {0.05, 0.2, 0.3, 0.35, 0.5, 0.6, 0.7};  // below 1 when shifted
  std::vector<double> later = knots;
  for (double& x : later) x += shift;
  ASSERT_LT(later.back(), 1);
  CurveProblem a(points, 3, 1e-12, energy_of(points, 0.01)), b(turned, 3, 1e-12, energy_of(turned, 0.01));
  ASSERT_TRUE(a.solve(knots));
  ASSERT_TRUE(b.solve(later));
  for (int k = 0; k < 50; ++k) {
    const double t = 0.05 + k / 50.0;
    const std::vector<double> x = evaluate(a.curve(), std::vector<double>{t}),
                              y = evaluate(b.curve(), std::vector<double>{t + shift});
    EXPECT_NEAR(x[0], y[0], 1e-8);
    EXPECT_NEAR(x[1], y[1], 1e-8);
  }
}

}  // namespace
}  // namespace knotfit::test
