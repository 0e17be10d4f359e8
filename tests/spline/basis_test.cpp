#include "knotfit/basis.h"

#include <gtest/gtest.h>

#include "knotfit/exceptions.h"
#include "spline/knots_generator.h"
#include "spline/reference.h"
#include "support/expect_gradient.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

std::vector<double> functions(const KnotVector& t, double x) {
  std::vector<double> values(static_cast<std::size_t>(t.degree()) + 1);
  basis_functions(t, t.find_span(x), x, values);
  return values;
}

std::vector<double> derivatives(const KnotVector& t, double x, int order) {
  std::vector<double> values(static_cast<std::size_t>((t.degree() + 1) * (order + 1)));
  basis_derivatives(t, t.find_span(x), x, order, values);
  return values;
}

RC_GTEST_PROP(Basis, IsAPartitionOfUnityAndNotNegative, ()) {
  const KnotVector t = *clamped_knots();
  const double x = *parameter();
  Long sum = 0;
  for (double value : functions(t, x)) {
    RC_ASSERT(value >= 0);
    sum += value;
  }
  RC_ASSERT(std::abs(static_cast<double>(sum - 1)) <= 2 * t.degree() * kEps);
}

TEST(Basis, IsAPartitionOfUnityOverOpenAndGradedKnots) {
  Random random;
  for (int k = 0; k < 10000; ++k) {
    const KnotVector t = random_knots(random, random.integer(1, kMaxDegree));
    Long sum = 0;
    for (double value : functions(t, random_parameter(random, t))) {
      EXPECT_GE(value, 0);
      sum += value;
    }
    EXPECT_LE(std::abs(static_cast<double>(sum - 1)), 2 * t.degree() * kEps);
  }
}

// A step of the recursion has 6 roundings of eps/2, none of them of a difference of computed
// numbers: each function is right to 3 degree eps of itself.
TEST(Basis, IsWhatTheRecursionGives) {
  Random random;
  for (int k = 0; k < 2000; ++k) {
    const KnotVector t = random_knots(random, random.integer(1, kMaxDegree));
    const double x = random.integer(0, 4) == 0 ? t.breaks()[0] : random_parameter(random, t);
    const Index span = t.find_span(x);
    const std::vector<double> values = functions(t, x);
    const Reference reference{t, span, x};
    for (Index a = 0; a <= t.degree(); ++a) {
      const double expected = static_cast<double>(reference(span - t.degree() + a, t.degree()));
      EXPECT_NEAR(values[a], expected, (3 * t.degree() + 1) * kEps * expected);
    }
  }
}

TEST(Basis, IsOneAtAClampedEnd) {
  for (int degree = 1; degree <= kMaxDegree; ++degree) {
    const KnotVector t = KnotVector::uniform(degree, 3);
    EXPECT_EQ(functions(t, 0).front(), 1);
    EXPECT_EQ(functions(t, 1).back(), 1);
  }
}

TEST(Basis, HasLocalSupport) {
  // The function i is one of the degree + 1 of a span just where t_i <= x < t_{i+degree+1}.
  Random random;
  for (int k = 0; k < 500; ++k) {
    const KnotVector t = random_knots(random, random.integer(1, kMaxDegree));
    const double x = random_parameter(random, t);
    const Index span = t.find_span(x);
    for (Index i = 0; i < t.size(); ++i)
      EXPECT_EQ(i >= span - t.degree() && i <= span, t[i] <= x && x < t[i + t.degree() + 1]);
  }
}

// A derivative is a difference of r levels; each term is right to 8 (degree + 1) eps of itself.
TEST(BasisDerivatives, AreWhatTheRecursionGives) {
  Random random;
  for (int k = 0; k < 300; ++k) {
    const KnotVector t = random_knots(random, random.integer(1, kMaxDegree));
    const int p = t.degree();
    const double x = random_parameter(random, t);
    const Index span = t.find_span(x);
    const std::vector<double> values = derivatives(t, x, p + 2);
    const Reference reference{t, span, x}, magnitude{t, span, x, true};
    for (int r = 0; r <= p + 2; ++r)
      for (Index a = 0; a <= p; ++a) {
        const double size = static_cast<double>(magnitude(span - p + a, p, r));
        EXPECT_NEAR(values[r * (p + 1) + a], static_cast<double>(reference(span - p + a, p, r)),
                    8 * (p + 1) * kEps * size)
            << "degree " << p << " derivative " << r;
      }
  }
}

TEST(BasisDerivatives, AreZeroAboveTheDegree) {
  const std::vector<double> values = derivatives(KnotVector::uniform(2, 3), 0.4, 6);
  for (std::size_t k = 9; k < values.size(); ++k) EXPECT_EQ(values[k], 0);
}

TEST(BasisDerivatives, HaveTheValuesAsTheirFirstRow) {
  Random random;
  for (int k = 0; k < 1000; ++k) {
    const KnotVector t = random_knots(random, random.integer(1, kMaxDegree));
    const double x = random_parameter(random, t);
    std::vector<double> all = derivatives(t, x, random.integer(0, 4));
    all.resize(static_cast<std::size_t>(t.degree()) + 1);
    EXPECT_EQ(all, functions(t, x));
  }
}

TEST(BasisDerivatives, AgreeWithDifferences) {
  Random random;
  for (int degree = 2; degree <= kMaxDegree; ++degree) {
    const KnotVector t = KnotVector::clamped(degree, std::vector<double>{0.3, 0.7});
    for (int r = 0; r < degree; ++r) {
      const double x = random.uniform(0.32, 0.68);
      const Index span = t.find_span(x);
      for (int a = 0; a <= degree; ++a) {
        const auto lower = [&](const std::vector<double>& at) {
          return derivatives(t, at[0], r)[static_cast<std::size_t>(r * (degree + 1) + a)];
        };
        const double slope = derivatives(t, x, r + 1)[static_cast<std::size_t>((r + 1) * (degree + 1) + a)];
        // Derivatives cancel; what they lose grows with the magnitudes of the terms.
        const double size = static_cast<double>(Reference{t, span, x, true}(span - degree + a, degree, r));
        const double lost = std::abs(lower({x})) > 0 ? size / std::abs(lower({x})) : 1;
        expect_gradient(lower, std::vector<double>{x}, std::vector<double>{slope}, 1e-3,
                        16 + 8 * degree * lost);
      }
    }
  }
}

TEST(Basis, NamesWhatIsWrong) {
  const KnotVector t = KnotVector::clamped(2, std::vector<double>{0.5, 0.5});
  std::vector<double> three(3), two(2);
  expect_throw<InvalidInput>([&] { basis_functions(t, 1, 0.1, three); }, "span 1 is not a non-empty span");
  expect_throw<InvalidInput>([&] { basis_functions(t, 3, 0.5, three); }, "span 3 is not a non-empty span");
  expect_throw<InvalidInput>([&] { basis_functions(t, 5, 1, three); }, "take it from find_span");
  expect_throw<InvalidInput>([&] { basis_functions(t, 2, 0.1, two); },
                             "3 basis values do not fit into 2 entries");
  expect_throw<InvalidInput>([&] { basis_derivatives(t, 2, 0.1, 1, three); },
                             "6 basis values do not fit into 3 entries");
  expect_throw<InvalidInput>([&] { basis_derivatives(t, 2, 0.1, -1, three); }, "order of a derivative is -1");
}

}  // namespace
}  // namespace knotfit::test
