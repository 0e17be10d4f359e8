#include "solve/banded.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

struct Pair {
  BandMatrix band;
  Eigen::MatrixXd full;
};

/// Diagonally dominant, so positive definite; the diagonal over `decades`.
Pair random_matrix(Random& random, Index n, Index bandwidth, double decades = 1) {
  Pair m{BandMatrix(n, bandwidth), Eigen::MatrixXd::Zero(n, n)};
  for (Index j = 0; j < n; ++j)
    for (Index i = j + 1; i < std::min(n, j + bandwidth + 1); ++i)
      m.full(i, j) = m.full(j, i) = random.uniform(-1, 1);
  for (Index j = 0; j < n; ++j)
    m.full(j, j) = m.full.col(j).cwiseAbs().sum() + random.log_uniform(std::pow(10, -decades), 1);
  for (Index j = 0; j < n; ++j)
    for (Index i = j; i < std::min(n, j + bandwidth + 1); ++i) {
      m.band.add(i, j, m.full(i, j) / 4);  // entries add up
      m.band.add(i, j, 3 * m.full(i, j) / 4);
    }
  return m;
}

TEST(BandMatrix, TraceAndNormAreThoseOfTheFullMatrix) {
  Random random;
  for (const auto& [n, bandwidth] : {std::pair<Index, Index>{1, 0}, {5, 0}, {6, 2}, {40, 7}, {5, 9}}) {
    const auto [band, full] = random_matrix(random, n, bandwidth);
    EXPECT_EQ(band.size(), n);
    EXPECT_EQ(band.bandwidth(), std::min(bandwidth, n - 1));
    EXPECT_NEAR(band.trace(), full.trace(), 8 * static_cast<double>(n) * kEps * full.trace());
    const double norm = full.cwiseAbs().colwise().sum().maxCoeff();
    EXPECT_NEAR(band.norm_1(), norm, 8 * static_cast<double>(n) * kEps * norm);
  }
}

TEST(BandMatrix, ForwardSolvesEveryColumnOfAPanel) {
  Random random;
  for (const auto& [n, bandwidth] : {std::pair<Index, Index>{1, 0}, {6, 2}, {40, 7}, {200, 30}, {5, 9}})
    for (Index columns : {1, 8, 19}) {
      auto [band, full] = random_matrix(random, n, bandwidth);
      const Eigen::MatrixXd b = Eigen::MatrixXd::Random(n, columns);
      Panel panel(n, columns);
      for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < columns; ++j) panel(i, j) = i < j ? 0 : b(i, j);  // leading zeros as well
      Eigen::MatrixXd expected(n, columns);
      for (Index j = 0; j < columns; ++j)
        for (Index i = 0; i < n; ++i) expected(i, j) = panel(i, j);
      ASSERT_TRUE(band.factor());
      const Eigen::LLT<Eigen::MatrixXd> llt(full);
      llt.matrixL().solveInPlace(expected);
      band.forward(panel);
      const double bound = 8 * static_cast<double>(n) * kEps * full.norm() * full.inverse().norm();
      for (Index j = 0; j < columns; ++j)
        for (Index i = 0; i < n; ++i) EXPECT_NEAR(panel(i, j), expected(i, j), bound);
      // X^T X of a part of the columns, added to what is there.
      const Index first = columns / 3, count = columns - first;
      std::vector<double> gram(static_cast<std::size_t>(count * count), 1.0);
      panel.add_gram(first, count, -2, gram.data());
      const Eigen::MatrixXd part = expected.rightCols(count);
      for (Index i = 0; i < count; ++i)
        for (Index j = 0; j < count; ++j)
          EXPECT_NEAR(gram[i * count + j], 1 - 2 * part.col(i).dot(part.col(j)),
                      static_cast<double>(n) * (kEps + 4 * bound) * (1 + part.squaredNorm()));
    }
}

TEST(BandMatrix, SolvesAsTheFullMatrix) {
  Random random;
  for (const auto& [n, bandwidth] :
       {std::pair<Index, Index>{1, 0}, {6, 2}, {40, 7}, {200, 30}, {200, 80}, {5, 9}})
    for (Index columns : {1, 3}) {
      auto [band, full] = random_matrix(random, n, bandwidth);
      const Eigen::MatrixXd x = Eigen::MatrixXd::Random(n, columns), b = full * x;
      std::vector<double> solution(b.data(), b.data() + b.size());
      ASSERT_TRUE(band.factor());
      band.solve(solution.data(), columns);
      const double condition = full.norm() * full.inverse().norm();
      for (Index k = 0; k < b.size(); ++k)
        EXPECT_NEAR(solution[k], x.data()[k], 4 * static_cast<double>(bandwidth + 2) * kEps * condition);
    }
}

TEST(BandMatrix, FactorRefusesWhatIsNotPositiveDefinite) {
  BandMatrix zero(3, 1);
  EXPECT_FALSE(zero.factor());
  BandMatrix indefinite(2, 1);
  indefinite.add(0, 0, 1);
  indefinite.add(1, 0, 2);
  indefinite.add(1, 1, 1);
  EXPECT_FALSE(indefinite.factor());
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    BandMatrix broken(2, 1);
    broken.add(0, 0, bad);
    broken.add(1, 1, 1);
    EXPECT_FALSE(broken.factor());
  }
}

TEST(BandMatrix, ConditionIsEstimatedFromBelowAndNear) {
  Random random;
  for (double decades : {0.0, 6.0}) {
    auto [band, full] = random_matrix(random, 60, 4, decades);
    if (decades > 0) {  // a small diagonal entry on its own
      for (Index k = 1; k <= 4; ++k) {
        band.add(20 + k, 20, -full(20 + k, 20));
        band.add(20, 20 - k, -full(20, 20 - k));
        full(20 + k, 20) = full(20, 20 + k) = full(20 - k, 20) = full(20, 20 - k) = 0;
      }
      band.add(20, 20, 1e-6 - full(20, 20));
      full(20, 20) = 1e-6;
    }
    auto norm = [](const Eigen::MatrixXd& m) { return m.cwiseAbs().colwise().sum().maxCoeff(); };
    const double expected = norm(full) * norm(full.inverse());
    const double norm_1 = band.norm_1();
    ASSERT_TRUE(band.factor());
    const double condition = band.condition(norm_1);
    EXPECT_LE(condition, expected * (1 + 1e-6));
    EXPECT_GE(condition, expected / 10);  // LAPACK's estimate is rarely off by more than 3 [Higham88]
  }
}

TEST(BandMatrix, ResetIsZeroAgain) {
  Random random;
  auto [band, full] = random_matrix(random, 10, 3);
  band.reset(4, 1);
  EXPECT_EQ(band.size(), 4);
  EXPECT_EQ(band.trace(), 0);
  EXPECT_EQ(band.norm_1(), 0);
}

TEST(BandMatrix, MoreUnknownsThanAnIntCountsIsRefused) {
  expect_throw<InvalidInput>([] { BandMatrix(Index{1} << 31, 3); }, "ask for fewer control points");
}

TEST(BandMatrix, TimesIsTheFullSymmetricProduct) {
  Random random;
  const Index n = 9, bandwidth = 3;
  BandMatrix a(n, bandwidth);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = j; i <= std::min(n - 1, j + bandwidth); ++i) {
      const double x = random.uniform(-1, 1);
      a.add(i, j, x);
      full(i, j) = full(j, i) = x;
    }
  std::vector<double> x;
  for (Index k = 0; k < 2 * n; ++k) x.push_back(random.uniform(-1, 1));
  const std::vector<double> y = a.times(x);
  const Eigen::MatrixXd expected = full * Eigen::Map<const Eigen::MatrixXd>(x.data(), n, 2);
  for (Index k = 0; k < 2 * n; ++k) EXPECT_NEAR(y[k], expected.data()[k], 1e-14);
}

TEST(BandMatrix, APivotOfRoundingIsRefusedUnlessItIsAskedFor) {
  for (const double least : {-1.0, 0.0}) {
    BandMatrix a(2, 1);
    a.add(0, 0, 1);
    a.add(1, 0, 1);
    a.add(1, 1, 1 + 4 * std::numeric_limits<double>::epsilon());
    EXPECT_EQ(least < 0 ? a.factor() : a.factor(least), least == 0);
  }
}

}  // namespace
}  // namespace knotfit::test
