#include "parameterize/mesh_factor.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>

#include "pattern.h"

namespace knotfit::mesh_map {
namespace {

// Sparse, and not of a mesh: several parts, a vertex alone, a vertex joined to all others.
Pattern odd_pattern() {
  Pattern pattern{40, {}};
  std::mt19937 random(3);
  for (int k = 0; k < 60; ++k) {
    const int a = static_cast<int>(random() % 38), b = static_cast<int>(random() % 38);
    const std::array<int, 2> edge{std::min(a, b), std::max(a, b)};
    if (a != b && std::find(pattern.edges.begin(), pattern.edges.end(), edge) == pattern.edges.end())
      pattern.edges.push_back(edge);
  }
  for (int k = 0; k < 38; k += 2) pattern.edges.push_back({k, 38});
  return pattern;
}

class Factors : public ::testing::TestWithParam<int> {
 protected:
  Pattern pattern() const { return GetParam() == 0 ? odd_pattern() : sheet_pattern(GetParam()); }
};

TEST_P(Factors, CholeskySolvesWhatADenseFactorSolves) {
  const Pattern p = pattern();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<double> diagonal(4 * static_cast<std::size_t>(p.vertices), 0), off(4 * p.edges.size());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(2 * p.vertices, 2 * p.vertices);
  for (std::size_t e = 0; e < p.edges.size(); ++e)
    for (int k = 0; k < 4; ++k) {
      off[4 * e + k] = number(random);
      const int row = 2 * p.edges[e][0] + k / 2, column = 2 * p.edges[e][1] + k % 2;
      dense(row, column) = dense(column, row) = off[4 * e + k];
    }
  for (int i = 0; i < p.vertices; ++i) {
    double* d = &diagonal[4 * static_cast<std::size_t>(i)];
    d[1] = d[2] = 0.3;  // diagonally dominant: positive definite
    d[0] = 1 + dense.row(2 * i).cwiseAbs().sum();
    d[3] = 1 + dense.row(2 * i + 1).cwiseAbs().sum();
    dense.block<2, 2>(2 * i, 2 * i) << d[0], d[1], d[2], d[3];
  }
  const Eigen::VectorXd right = Eigen::VectorXd::Random(2 * p.vertices);
  const Eigen::VectorXd expected = dense.ldlt().solve(right);
  const Elimination elimination(p.vertices, p.edges);
  BlockCholesky factor(elimination);
  ASSERT_TRUE(factor.factor(diagonal, off));
  std::vector<double> x(right.data(), right.data() + right.size());
  factor.solve(x);
  for (int i = 0; i < 2 * p.vertices; ++i) EXPECT_NEAR(x[i], expected[i], 1e-13) << i;
}

TEST_P(Factors, LUSolvesWhatADenseFactorSolves) {
  const Pattern p = pattern();
  std::mt19937 random(2);
  std::uniform_real_distribution<double> weight(0.1, 1);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(p.vertices, p.vertices);
  std::vector<double> forward, backward, sum(static_cast<std::size_t>(p.vertices), 0.01);
  for (const auto& [a, b] : p.edges) {
    forward.push_back(weight(random));
    backward.push_back(weight(random));
    sum[a] += forward.back();
    sum[b] += backward.back();
  }
  for (std::size_t e = 0; e < p.edges.size(); ++e) {
    const auto [a, b] = p.edges[e];
    dense(a, b) = forward[e] /= -sum[a];
    dense(b, a) = backward[e] /= -sum[b];
  }
  const Eigen::MatrixXd right = Eigen::MatrixXd::Random(p.vertices, 2);
  const Eigen::MatrixXd expected = dense.partialPivLu().solve(right);
  const Elimination elimination(p.vertices, p.edges);
  DirectedLU factor(elimination);
  ASSERT_TRUE(factor.factor(forward, backward));
  std::vector<double> x;
  for (int i = 0; i < p.vertices; ++i) x.insert(x.end(), {right(i, 0), right(i, 1)});
  factor.solve(x);
  // Rows sum to 0.01 at least: a condition of some hundred.
  for (int i = 0; i < p.vertices; ++i)
    for (int c = 0; c < 2; ++c) EXPECT_NEAR(x[2 * i + c], expected(i, c), 1e-11) << i;
}

INSTANTIATE_TEST_SUITE_P(Patterns, Factors, ::testing::Values(0, 2, 5, 20));

TEST(BlockCholesky, RefusesAMatrixThatIsNotPositive) {
  const Pattern p = sheet_pattern(3);
  const Elimination elimination(p.vertices, p.edges);
  BlockCholesky factor(elimination);
  std::vector<double> diagonal(4 * static_cast<std::size_t>(p.vertices), 0), off(4 * p.edges.size(), 0);
  for (std::size_t i = 0; i < diagonal.size(); i += 4) diagonal[i] = diagonal[i + 3] = 1;
  EXPECT_TRUE(factor.factor(diagonal, off));
  off[0] = 2;
  EXPECT_FALSE(factor.factor(diagonal, off));
}

}  // namespace
}  // namespace knotfit::mesh_map
