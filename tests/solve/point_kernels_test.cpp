#include "solve/point_kernels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/dense_reference.h"
namespace knotfit::test {
namespace {

/// One cell of 200 points with values and weights, and sums over them by the definition of the
/// Legendre polynomials, in long double.
struct Cell {
  ParameterizedPoints points;
  CellOrder order;
  CellPiece piece;
  Cell(Random& random, int dimension, bool weighted, int outer, int inner)
      : points(random_points(random, 200, dimension, weighted)), order(points) {
    order.sort(Axis(outer), Axis(inner), false);
    piece = order.pieces().at(0);
  }
  template <class Term>
  std::pair<double, double> sum(int a, int b, const Term& term) const {
    long double value = 0, magnitude = 0;
    for (Index k = piece.begin; k < piece.end; ++k) {
      const long double x =
          std::legendre(static_cast<unsigned>(a), static_cast<long double>(order.outer(k))) *
          std::legendre(static_cast<unsigned>(b), static_cast<long double>(order.inner(k))) *
          order.weight(k) * term(k);
      value += x;
      magnitude += std::abs(order.weight(k) * term(k));
    }
    // Rounding: one a term of the sum, a few a step of either recurrence (|P| <= 1).
    return {static_cast<double>(value), (200 + 8.0 * (a + b + 2)) * kEps * static_cast<double>(magnitude)};
  }
};

class Kernels : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(Kernels, MomentsAreTheSums) {
  const auto [outer, inner] = GetParam();
  Random random;
  for (bool weighted : {false, true})
    for (int dimension : {1, 2, 3}) {
      const Cell cell(random, dimension, weighted, outer, inner);
      const int qo = 2 * outer + 1, qi = 2 * inner + 1, stride = padded(qi), wo = outer + 1, wi = inner + 1;
      // They add to what is there.
      std::vector<double> matrix(static_cast<std::size_t>(qo * stride), 1.0);
      std::vector<double> rhs(static_cast<std::size_t>(dimension * wo * wi), 2.0);
      add_moments(cell.order, cell.piece, outer, inner, matrix.data(), rhs.data());
      for (int a = 0; a < qo; ++a)
        for (int b = 0; b < qi; ++b) {
          const auto [expected, tolerance] = cell.sum(a, b, [](Index) { return 1.0; });
          EXPECT_NEAR(matrix[a * stride + b] - 1, expected, tolerance);
        }
      for (int e = 0; e < dimension; ++e)
        for (int a = 0; a < wo; ++a)
          for (int b = 0; b < wi; ++b) {
            const auto [expected, tolerance] =
                cell.sum(a, b, [&, e = e](Index k) { return cell.order.value(k)[e]; });
            EXPECT_NEAR(rhs[(e * wo + a) * wi + b] - 2, expected, tolerance);
          }
    }
}

TEST_P(Kernels, RightHandSideAloneIsTheSame) {
  const auto [outer, inner] = GetParam();
  Random random;
  for (int dimension : {1, 3}) {
    const Cell cell(random, dimension, true, outer, inner);
    const int wo = outer + 1, wi = inner + 1;
    std::vector<double> x = random_numbers(random, cell.order.size() * dimension);
    std::vector<double> rhs(static_cast<std::size_t>(dimension * wo * wi), 0.0);
    add_rhs_moments(cell.order, cell.piece, outer, inner, x.data(), rhs.data());
    for (int e = 0; e < dimension; ++e)
      for (int a = 0; a < wo; ++a)
        for (int b = 0; b < wi; ++b) {
          const auto [expected, tolerance] = cell.sum(
              a, b, [&, e = e](Index k) { return x[cell.order.stored(k) * cell.order.dimension() + e]; });
          EXPECT_NEAR(rhs[(e * wo + a) * wi + b], expected, tolerance);
        }
  }
}

TEST_P(Kernels, ResidualsAreValueMinusData) {
  const auto [outer, inner] = GetParam();
  Random random;
  for (int dimension : {1, 3}) {
    const Cell cell(random, dimension, dimension == 3, outer, inner);
    const int wo = outer + 1, wi = inner + 1;
    const std::vector<double> c = random_numbers(random, dimension * wo * wi);
    std::vector<double> x(static_cast<std::size_t>(cell.order.size() * dimension),
                          1e300);  // written, not added to
    const Index counted = 150;
    const ResidualSums sums =
        set_residuals(cell.order, cell.piece, outer, inner, counted, c.data(), x.data());
    double squares = 0, weighted = 0, max = 0;
    for (Index k = cell.piece.begin; k < cell.piece.end; ++k) {
      double square = 0;
      for (int e = 0; e < dimension; ++e) {
        const double r = x[cell.order.stored(k) * dimension + e];
        square += r * r;
        long double expected = -static_cast<long double>(cell.order.value(k)[e]);
        for (int a = 0; a < wo; ++a)
          for (int b = 0; b < wi; ++b)
            expected +=
                c[(e * wo + a) * wi + b] *
                std::legendre(static_cast<unsigned>(a), static_cast<long double>(cell.order.outer(k))) *
                std::legendre(static_cast<unsigned>(b), static_cast<long double>(cell.order.inner(k)));
        EXPECT_NEAR(x[cell.order.stored(k) * dimension + e], static_cast<double>(expected),
                    8 * (wo + wi) * wo * wi * kEps);
      }
      weighted += cell.order.weight(k) * square;
      if (cell.order.input(cell.order.stored(k)) >= counted) continue;
      squares += square;
      max = std::max(max, square);
    }
    EXPECT_NEAR(sums.squares, squares, 200 * kEps * squares);
    EXPECT_NEAR(sums.weighted, weighted, 200 * kEps * weighted);
    EXPECT_EQ(sums.max, max);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Kernels,
                         testing::Values(std::pair{1, 1}, std::pair{2, 2}, std::pair{3, 3}, std::pair{4, 4},
                                         std::pair{5, 5}, std::pair{6, 6}, std::pair{9, 9}, std::pair{1, 9},
                                         std::pair{3, 2}, std::pair{2, 5}));

TEST(Padding, IsToMultiplesOfFour) {
  EXPECT_EQ(padded(3), 4);
  EXPECT_EQ(padded(4), 4);
  EXPECT_EQ(padded(7), 8);
  EXPECT_EQ(padded(19), 20);
}

}  // namespace
}  // namespace knotfit::test
