#include "knotfit/curve.h"

#include <gtest/gtest.h>

#include <limits>

#include "knotfit/exceptions.h"
#include "spline/reference.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using Numbers = std::vector<double>;
const double kNan = std::numeric_limits<double>::quiet_NaN();

double scale(const Curve& c) {
  double largest = 0;
  for (double x : c.control_points()) largest = std::max(largest, std::abs(x));
  return largest;
}

TEST(Curve, HasTheDerivativesOfTheRecursion) {
  Random random;
  for (int k = 0; k < 200; ++k) {
    const Curve c = random_curve(random, random.integer(1, 4));
    const int p = c.degree(), dim = c.dimension();
    const double t = random_parameter(random, c.knots());
    const Numbers all = evaluate_derivatives(c, t, p + 1);
    const Index span = c.knots().find_span(t);
    const Reference basis{c.knots(), span, t}, magnitude{c.knots(), span, t, true};
    for (int r = 0; r <= p + 1; ++r)
      for (int d = 0; d < dim; ++d) {
        Long expected = 0, size = 0;
        for (Index i = span - p; i <= span; ++i) {
          const Long point = c.control_points()[static_cast<std::size_t>(i * dim + d)];
          expected += basis(i, p, r) * point;
          size += magnitude(i, p, r) * std::abs(point);
        }
        EXPECT_NEAR(all[static_cast<std::size_t>(r * dim + d)], static_cast<double>(expected),
                    (8 * (p + 1) + 1) * kEps * static_cast<double>(size));
        if (r > p) {
          EXPECT_EQ(all[static_cast<std::size_t>(r * dim + d)], 0);
        }
      }
  }
}

TEST(Curve, GivesTheSameBitsForManyParametersAsForOne) {
  Random random;
  for (int k = 0; k < 50; ++k) {
    const Curve c = random_curve(random, random.integer(1, 4));
    Numbers t(static_cast<std::size_t>(random.integer(0, 300)));
    for (double& x : t) x = random.uniform(c.knots().first() - 0.1, c.knots().last() + 0.1);
    const Numbers many = evaluate(c, t);
    ASSERT_EQ(many.size(), t.size() * static_cast<std::size_t>(c.dimension()));
    for (std::size_t l = 0; l < t.size(); ++l) {
      const auto at = many.begin() + static_cast<Index>(l) * c.dimension();
      EXPECT_EQ(evaluate_derivatives(c, t[l], 0), Numbers(at, at + c.dimension()));
    }
  }
}

TEST(Curve, ClampsItsParameterAndKeepsNan) {
  Random random;
  const Curve c = random_curve(random, 2);
  EXPECT_EQ(evaluate_derivatives(c, c.knots().last() + 9, 2), evaluate_derivatives(c, c.knots().last(), 2));
  for (double x : evaluate_derivatives(c, kNan, 12)) EXPECT_TRUE(std::isnan(x));
  for (double x : evaluate(c, Numbers{kNan})) EXPECT_TRUE(std::isnan(x));
}

TEST(Curve, IsUnchangedByRefinement) {
  Random random;
  for (int k = 0; k < 100; ++k) {
    const Curve c = random_curve(random, 3);
    const double width = c.knots().last() - c.knots().first();
    Numbers added(static_cast<std::size_t>(random.integer(0, 10)));
    for (double& x : added) x = c.knots().first() + width * random.uniform(0.01, 0.99);
    std::sort(added.begin(), added.end());
    const Curve refined = refine(c, added);
    EXPECT_EQ(refined.size(), c.size() + static_cast<Index>(added.size()));
    Numbers t(100);
    for (double& x : t) x = random_parameter(random, c.knots());
    const Numbers a = evaluate(c, t), b = evaluate(refined, t);
    const double rounding = (4 * c.degree() + 8 * (c.degree() + 1)) * kEps * scale(c);
    for (std::size_t l = 0; l < a.size(); ++l) EXPECT_NEAR(a[l], b[l], rounding);
    if (added.size() == 1) {
      EXPECT_EQ(insert_knot(c, added[0]), refined);
    }
  }
}

TEST(Curve, ReproducesALineFromItsGrevilleAbscissae) {
  Random random;
  for (int k = 0; k < 100; ++k) {
    const KnotVector t = random_knots(random, random.integer(1, kMaxDegree));
    const Curve c(t, 1, t.greville());
    const double size = std::max(std::abs(t.knots().front()), std::abs(t.knots().back()));
    for (int l = 0; l < 20; ++l) {
      const double x = random_parameter(random, t);
      EXPECT_NEAR(evaluate(c, Numbers{x})[0], x, (4 + 4 * (t.degree() + 2)) * kEps * size);
    }
  }
}

TEST(Curve, NamesWhatIsWrong) {
  const KnotVector t = KnotVector::uniform(2, 1);
  expect_throw<InvalidInput>([&] { Curve(t, 2, Numbers(7)); },
                             "the control polygon has 7 numbers; 4 control points of dimension 2 need 8");
  expect_throw<InvalidInput>([&] { Curve(t, 0, {}); }, "a curve's dimension is 0");
  expect_throw<InvalidInput>([&] { Curve(KnotVector(), 1, {}); }, "a curve needs a knot vector");
  expect_throw<InvalidInput>(
      [&] {
        Curve(t, 2, {0, 0, 0, 0, 0, kNan, 0, 0});
      },
      "control point 2 has the coordinate nan");
  const Curve c(t, 1, Numbers(4, 1.0));
  expect_throw<InvalidInput>([&] { evaluate_derivatives(c, 0, -1); }, "order of a derivative is -1");
  expect_throw<InvalidInput>([&] { insert_knot(c, 1); }, "knot 1 cannot be inserted");
  expect_throw<InvalidInput>([&] { refine(c, Numbers{0.7, 0.2}); }, "not sorted");
  expect_throw<InvalidInput>([] { evaluate(Curve(), Numbers{0}); }, "the curve is empty");
  expect_throw<InvalidInput>([] { evaluate_derivatives(Curve(), 0, 1); }, "the curve is empty");
  expect_throw<InvalidInput>([] { insert_knot(Curve(), 0.5); }, "the curve is empty");
}

}  // namespace
}  // namespace knotfit::test
