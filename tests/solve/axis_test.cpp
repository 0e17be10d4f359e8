#include "solve/axis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/basis.h"
#include "spline/reference.h"
#include "support/dense_reference.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

/// Degrees 1 to 9, interior knots of multiplicity up to degree + 1.
std::vector<Axis> random_axes(Random& random, int each) {
  std::vector<Axis> axes;
  for (int degree = 1; degree <= kMaxDegree; ++degree)
    for (int k = 0; k < each; ++k)
      axes.push_back(Axis(degree, random_interior(random, random.integer(0, 8), degree + 1)));
  return axes;
}

TEST(Axis, LegendreValuesAreThoseOfTheStandardLibrary) {
  for (double t : {-1.0, -0.7, -0.1, 0.0, 0.3, 0.99, 1.0}) {
    double p[2 * kMaxDegree + 2];
    legendre_values(t, 2 * kMaxDegree + 2, p);
    for (int a = 0; a < 2 * kMaxDegree + 2; ++a)
      // Each step of the recurrence rounds a few times and adds at most its two predecessors' errors.
      EXPECT_NEAR(p[a], std::legendre(static_cast<unsigned>(a), t), 8 * (a + 1) * kEps) << a << " at " << t;
  }
}

TEST(Axis, CountsSpansAndFunctions) {
  const Axis one(3);
  EXPECT_EQ(one.spans(), 1);
  EXPECT_EQ(one.functions(), 4);
  const Axis doubled(2, std::vector{0.25, 0.5, 0.5});
  EXPECT_EQ(doubled.spans(), 4);
  EXPECT_EQ(doubled.functions(), 6);
  EXPECT_EQ(doubled.functions(), doubled.knots().size());
  EXPECT_EQ(doubled.length(1), 0.25);
  EXPECT_EQ(doubled.length(2), 0);
  EXPECT_EQ(doubled.low(3), 0.5);
}

TEST(Axis, SpansAreThoseOfTheKnotVector) {
  Random random;
  for (const Axis& axis : random_axes(random, 20)) {
    auto expect_span = [&](double x) {
      if (x < 0 || x > 1) return;
      EXPECT_EQ(axis.span(x) + axis.degree(), axis.knots().find_span(x)) << x;
    };
    for (int k = 0; k < 500; ++k) expect_span(random.unit());
    for (double knot : axis.knots().breaks()) {
      expect_span(knot);
      expect_span(std::nextafter(knot, 0.0));
      expect_span(std::nextafter(knot, 1.0));
    }
  }
}

TEST(Axis, SpansEndAtTheirKnotsWhereDifferencesRound) {
  const double low = 0x1p-54, high = 1 - 0x1p-53;
  ASSERT_NE(low + (high - low), high);
  const Axis axis(3, std::vector{low, high});
  EXPECT_EQ(axis.span(high), 2);
  EXPECT_EQ(axis.span(std::nextafter(high, 0.0)), 1);
}

TEST(Axis, SpansAreRightOnThousandsOfUnequalKnots) {
  Random random;
  std::vector<double> interior = random_numbers(random, 6000);
  for (double& x : interior) x = (x + 1) / 2;
  std::sort(interior.begin(), interior.end());
  const Axis axis(3, interior);
  for (double x : interior) {
    EXPECT_EQ(axis.span(x) + 3, axis.knots().find_span(x));
    const double near = std::nextafter(x, 0.0);
    EXPECT_EQ(axis.span(near) + 3, axis.knots().find_span(near));
  }
}

TEST(Axis, LocalCoordinateRunsFromMinusOneToOne) {
  Random random;
  for (const Axis& axis : random_axes(random, 3))
    for (int k = 0; k < 200; ++k) {
      const double x = random.unit();
      const Index s = axis.span(x);
      const double t = axis.local(s, x);
      EXPECT_NEAR(t, 2 * (x - axis.low(s)) / axis.length(s) - 1, 4 * kEps);
      EXPECT_LE(std::abs(t), 1 + 4 * kEps);
    }
}

TEST(Axis, BasisTableGivesTheBasisFunctions) {
  Random random;
  for (const Axis& axis : random_axes(random, 6)) {
    const int m = axis.degree(), w = axis.width();
    // A coefficient is (a + 1/2) times a quadrature of 2m + 1 positive terms that sum to at most 2,
    // each within a few eps a degree; w of them are added up.
    const double tolerance = w * (2 * m + 1) * (6 * m + 8) * kEps;
    for (int k = 0; k < 30; ++k) {
      const double x = random.unit();
      const Index s = axis.span(x);
      double p[2 * kMaxDegree + 2];
      legendre_values(axis.local(s, x), std::max(2, w), p);
      const Reference expected{axis.knots(), s + m, x};
      for (int i = 0; i < w; ++i) {
        double value = 0;
        for (int a = 0; a < w; ++a) value += axis.basis(s)[a * w + i] * p[a];
        EXPECT_NEAR(value, static_cast<double>(expected(s + i, m)), tolerance) << "degree " << m;
      }
    }
  }
}

TEST(Axis, ProductTableGivesTheProductsOfBasisFunctions) {
  Random random;
  for (const Axis& axis : random_axes(random, 6)) {
    const int m = axis.degree(), w = axis.width(), q = axis.moments();
    const double tolerance = q * (4 * m + 1) * (8 * m + 12) * kEps;  // as above, 2m + 1 coefficients
    for (int k = 0; k < 30; ++k) {
      const double x = random.unit();
      const Index s = axis.span(x);
      double p[2 * kMaxDegree + 2];
      legendre_values(axis.local(s, x), q, p);
      const Reference b{axis.knots(), s + m, x};
      int row = 0;
      for (int i = 0; i < w; ++i)
        for (int i2 = 0; i2 <= i; ++i2, ++row) {
          double value = 0;
          for (int a = 0; a < q; ++a) value += axis.products(s)[row * q + a] * p[a];
          EXPECT_NEAR(value, static_cast<double>(b(s + i, m) * b(s + i2, m)), tolerance) << "degree " << m;
        }
      EXPECT_EQ(row, axis.pairs());
    }
  }
}

TEST(Axis, SpansOfNoLengthHaveNoTable) {
  const Axis axis(3, std::vector{0.5, 0.5});
  ASSERT_EQ(axis.length(1), 0);
  for (int k = 0; k < axis.width() * axis.width(); ++k) EXPECT_EQ(axis.basis(1)[k], 0);
  for (int k = 0; k < axis.pairs() * axis.moments(); ++k) EXPECT_EQ(axis.products(1)[k], 0);
}

TEST(Axis, GramMatricesAreTheIntegrals) {
  Random random;
  for (const Axis& axis : random_axes(random, 3))
    for (int r = 0; r <= 2; ++r) {
      const std::vector<double> band = axis.gram(r);
      const Eigen::MatrixXd expected = gram_matrix(axis.knots(), r);
      const int w = axis.width();
      ASSERT_EQ(static_cast<Index>(band.size()), axis.functions() * w);
      for (Index i = 0; i < axis.functions(); ++i)
        for (Index k = 0; k < w; ++k) {
          if (k > i) {
            EXPECT_EQ(band[i * w + k], 0);
            continue;
          }
          // |B_i B_j| integrates to at most the mean of the two diagonal entries [Cauchy]; a
          // derivative's differences lose up to 2^r, each quadrature some eps a degree.
          const double scale = std::sqrt(expected(i, i) * expected(i - k, i - k));
          EXPECT_NEAR(band[i * w + k], expected(i, i - k), 64 * (axis.degree() + 1) * (1 << r) * kEps * scale)
              << "degree " << axis.degree() << ", derivative " << r;
        }
    }
}

TEST(Axis, OfAPeriodRunsOnOverTheSeam) {
  const std::vector<double> period{0.05, 0.2, 0.3, 0.55, 0.6, 0.9};
  for (int degree : {1, 2, 3, 5}) {
    const Axis axis = Axis::periodic(degree, period);
    ASSERT_TRUE(axis.is_periodic());
    ASSERT_EQ(axis.functions(), 6);
    const auto width = static_cast<std::size_t>(axis.width());
    std::vector<double> b(width);
    // Every place lies in its span, and a function that leaves at the end comes back at the start.
    std::vector<double> at_start(6, 0.0), at_end(6, 0.0);
    for (double x : {0.05, 0.0999, 0.3, 0.57, 0.95, 1.04}) {
      const Index s = axis.span(x);
      EXPECT_LE(axis.low(s), x);
      EXPECT_LT(x, axis.low(s) + axis.length(s));
    }
    basis_functions(axis.knots(), degree, 0.05, b);
    for (int i = 0; i <= degree; ++i) at_start[axis.function(0, i)] += b[i];
    basis_functions(axis.knots(), 5 + degree, 1.05, b);
    for (int i = 0; i <= degree; ++i) at_end[axis.function(5, i)] += b[i];
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(at_start[i], at_end[i], 1e-14) << "degree " << degree;
    // The functions add up to 1: so do their integrals of products to the period, and of derivatives to 0.
    for (int r = 0; r <= std::min(2, degree); ++r) {
      const std::vector<double> band = axis.gram(r);
      double sum = 0, magnitude = 0;
      for (Index i = 0; i < 6; ++i)
        for (int k = 0; k <= degree; ++k) {
          const double entry = (k == 0 ? 1 : 2) * band[i * axis.width() + k];
          sum += entry;
          magnitude += std::abs(entry);
        }
      EXPECT_NEAR(sum, r == 0 ? 1 : 0, 1e-13 * magnitude) << "degree " << degree << ", derivative " << r;
    }
  }
}

}  // namespace
}  // namespace knotfit::test
