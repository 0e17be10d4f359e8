// The normal equations of scattered points against full matrices.
#include "solve/banded_system.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/threads.h"
#include "support/dense_reference.h"
namespace knotfit::test {
namespace {

struct Case {
  int degree_u, degree_v, breaks_u, breaks_v, dimension;
  bool weighted;
  Index points = 600;
  int multiplicity = 1;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << "degree " << c.degree_u << "x" << c.degree_v << ", " << c.breaks_u << " x " << c.breaks_v
             << " breaks, dimension " << c.dimension << (c.weighted ? ", weighted" : "");
}

class Assembly : public testing::TestWithParam<Case> {};

/// |G x - b| <= rounding of the terms: what a correct G and b, and a stable solver, leave.
void expect_solves(const Eigen::MatrixXd& g, const Eigen::MatrixXd& x, const Eigen::MatrixXd& b,
                   const Eigen::MatrixXd& magnitude, double rounding) {
  const Eigen::MatrixXd off = (g * x - b).cwiseAbs();
  // Cholesky is backward stable by columns: |dG| <= c eps |L||L^T|, no entry of which passes
  // sqrt(G_ii G_jj) [Higham02 10.3].
  const Eigen::VectorXd root = g.diagonal().cwiseSqrt();
  const Eigen::MatrixXd bound = rounding * (root * (root.transpose() * x.cwiseAbs()) + magnitude);
  for (Index i = 0; i < off.rows(); ++i)
    for (Index e = 0; e < off.cols(); ++e) EXPECT_LE(off(i, e), bound(i, e)) << "equation " << i;
}

TEST_P(Assembly, IsThatOfTheFullMatrices) {
  const Case c = GetParam();
  Random random;
  const Axis u(c.degree_u, random_interior(random, c.breaks_u, c.multiplicity));
  const Axis v(c.degree_v, random_interior(random, c.breaks_v, c.multiplicity));
  const ParameterizedPoints points = random_points(random, c.points, c.dimension, c.weighted);
  // The moments pass through (2m+1)^2 coefficients of tables that are good to (6m+8) eps or so, and
  // sums over all points of a cell.
  const double m = std::max(c.degree_u, c.degree_v);
  const double rounding = (2 * m + 1) * (2 * m + 1) * (6 * m + 8) * kEps;
  for (double floor : {1e-9, 1e-2}) {  // at 1e-2 the energy is as large as the data's part
    const DenseProblem dense(points, u.knots(), v.knots(), floor);
    const Eigen::MatrixXd magnitude =
        dense.a.cwiseAbs().transpose() * dense.w.asDiagonal() * dense.data.cwiseAbs();
    BandedSystem backend(points);
    ASSERT_TRUE(backend.factor(u, v, floor));
    EXPECT_NEAR(backend.smoothing(), dense.lambda, 1e-9 * dense.lambda);
    const std::vector<double> net = backend.project_data();
    expect_solves(dense.g, as_matrix(net, c.dimension), dense.rhs, magnitude, rounding);

    // Residuals of any net, and their projection.
    const std::vector<double> other = random_numbers(random, static_cast<Index>(net.size()));
    const Eigen::MatrixXd r = dense.a * as_matrix(other, c.dimension) - dense.data;
    const ResidualSums sums = backend.residuals(other);
    EXPECT_NEAR(sums.squares, r.squaredNorm(), rounding * r.squaredNorm());
    EXPECT_NEAR(sums.max, r.rowwise().norm().maxCoeff(), rounding);
    const std::vector<double> errors = backend.errors();
    for (Index k = 0; k < points.size(); ++k) EXPECT_NEAR(errors[k], r.row(k).norm(), rounding);
    expect_solves(dense.g, as_matrix(backend.project_residual(), c.dimension),
                  dense.a.transpose() * dense.w.asDiagonal() * r,
                  dense.a.cwiseAbs().transpose() * dense.w.asDiagonal() * r.cwiseAbs(), rounding);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Assembly,
    testing::Values(Case{3, 3, 6, 4, 1, false}, Case{3, 3, 4, 6, 1, true}, Case{3, 3, 5, 5, 3, true},
                    Case{3, 3, 5, 4, 2, true, 600, 4}, Case{1, 1, 7, 5, 2, true}, Case{2, 2, 5, 7, 1, true},
                    Case{4, 4, 4, 3, 2, false}, Case{5, 5, 3, 4, 1, true}, Case{6, 6, 2, 3, 1, true},
                    Case{2, 3, 5, 4, 3, true}, Case{3, 2, 5, 4, 3, true}, Case{2, 3, 2, 9, 1, false},
                    Case{1, 4, 6, 3, 1, true}, Case{9, 2, 2, 5, 1, true}, Case{7, 7, 0, 0, 1, false},
                    Case{3, 3, 0, 7, 1, true}, Case{3, 3, 9, 0, 1, true},
                    Case{3, 3, 1, 0, 2, true, 15000},  // cells longer than a chunk
                    Case{3, 2, 0, 1, 1, true, 30000}));

TEST(Assembly, SameBitsForOneAndTwoThreads) {
  Random random;
  const Axis u(3, random_interior(random, 12)), v(3, random_interior(random, 9));
  ParameterizedPoints points = random_points(random, 60000, 2, true);
  for (std::size_t k = 0; k < points.uv.size() / 2; ++k) points.uv[k] *= 0.01;  // long cells too
  std::vector<double> first_net, first_correction;
  for (int threads : {1, 2, 4}) {
    set_thread_count(threads);
    BandedSystem backend(points);
    ASSERT_TRUE(backend.factor(u, v, 1e-9));
    const std::vector<double> net = backend.project_data();
    const double squares = backend.residuals(net).squares;
    std::vector<double> correction = backend.project_residual();
    correction.push_back(squares);
    if (threads == 1) {
      first_net = net;
      first_correction = correction;
    }
    EXPECT_EQ(net, first_net) << threads << " threads";
    EXPECT_EQ(correction, first_correction) << threads << " threads";
  }
  set_thread_count(0);
}

TEST(Assembly, WithoutAFloorEmptyCellsAreFoundSingular) {
  Random random;
  ParameterizedPoints points = random_points(random, 500, 1);
  for (double& x : points.uv) x /= 2;
  const Axis axis(3, std::vector{0.1, 0.2, 0.3, 0.4, 0.6, 0.7, 0.8, 0.9});
  BandedSystem backend(points);
  EXPECT_FALSE(backend.factor(axis, axis, 0));
  EXPECT_TRUE(backend.factor(axis, axis, 1e-9));
  EXPECT_EQ(backend.empty_cells(), 81 - 25);
}

}  // namespace
}  // namespace knotfit::test
