#include "knotfit/knot_vector.h"

#include <gtest/gtest.h>

#include <limits>

#include "knotfit/exceptions.h"
#include "spline/knots_generator.h"
#include "spline/reference.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using Numbers = std::vector<double>;
const double kInf = std::numeric_limits<double>::infinity(), kNan = std::numeric_limits<double>::quiet_NaN();

void expect_invalid(int degree, const Numbers& knots, const std::string& words) {
  expect_throw<InvalidInput>([&] { KnotVector(degree, knots); }, words);
}

TEST(KnotVector, NamesWhatIsWrongWithItsKnots) {
  expect_invalid(0, {0, 0, 1, 1}, "degree 0 is outside [1, 9]");
  expect_invalid(10, Numbers(40, 0), "degree 10 is outside [1, 9]");
  expect_invalid(3, {0, 0, 0, 0, 1, 1, 1}, "degree 3 needs at least 8 knots; there are 7");
  expect_invalid(1, {0, 0, kNan, 1, 1}, "knot 2 is nan; knots must be finite");
  expect_invalid(1, {-kInf, 0, 1, 1}, "knot 0 is -inf");
  expect_invalid(1, {0, 0, 0.7, 0.3, 1, 1}, "knot 3 (0.3) is less than knot 2 (0.7)");
  expect_invalid(1, {0, 0, 0.5, 0.5, 0.5, 1, 1}, "knot 4 (0.5) has a multiplicity above degree + 1 = 2");
  expect_invalid(1, {0, 0, 0, 1, 1}, "knot 2 (0) has a multiplicity above degree + 1 = 2");
}

TEST(KnotVector, RefusesAnEmptyDomain) {
  expect_invalid(2, {0, 1, 2, 2, 3, 4}, "the domain [2, 2] of the knots is empty");
  expect_throw<InvalidInput>([] { KnotVector::clamped(2, {}, 1, 1); },
                             "the domain [1, 1] of the knots is empty");
  expect_throw<InvalidInput>([] { KnotVector::clamped(2, {}, 0, kInf); }, "empty or not finite");
  expect_invalid(1, {-1e308, -1e308, 1e308, 1e308}, "too far apart");
}

TEST(KnotVector, NamesWhatIsWrongWithInteriorKnots) {
  expect_throw<InvalidInput>(
      [] {
        KnotVector::clamped(3, Numbers{0.5, 1});
      },
      "interior knot 1 (1) is not inside (0, 1)");
  expect_throw<InvalidInput>([] { KnotVector::clamped(3, Numbers{kNan}); }, "interior knot 0 (nan)");
  expect_throw<InvalidInput>(
      [] {
        KnotVector::clamped(3, Numbers{0.5, 0.4});
      },
      "interior knot 1 (0.4) is less than the one before (0.5)");
  expect_throw<InvalidInput>([] { KnotVector::clamped(12, Numbers{0.5}); }, "degree 12 is outside [1, 9]");
  expect_throw<InvalidInput>([] { KnotVector::uniform(3, -1); }, "number of interior knots is -1");
}

TEST(KnotVector, ClampedKnotsAreTheInteriorBetweenFullEnds) {
  const KnotVector t = KnotVector::clamped(2, Numbers{0.25, 0.5, 0.5});
  EXPECT_EQ(t.knots(), (Numbers{0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1}));
  EXPECT_EQ(t.size(), 6);
  EXPECT_EQ(t.first(), 0);
  EXPECT_EQ(t.last(), 1);
  EXPECT_TRUE(t.is_clamped());
  EXPECT_EQ(t.interior(), (Numbers{0.25, 0.5, 0.5}));
  EXPECT_EQ(t.breaks(), (Numbers{0, 0.25, 0.5, 1}));
  EXPECT_EQ(t.span_count(), 3);
  EXPECT_EQ(t.multiplicity(0.5), 2);
  EXPECT_EQ(t.multiplicity(0), 3);
  EXPECT_EQ(t.multiplicity(0.3), 0);
}

TEST(KnotVector, UniformKnotsAreEquallySpaced) {
  EXPECT_EQ(KnotVector::uniform(1, 3).interior(), (Numbers{0.25, 0.5, 0.75}));
  EXPECT_EQ(KnotVector::uniform(3, 1, 2, 6).interior(), (Numbers{4}));
  EXPECT_EQ(KnotVector::uniform(3, 0, 2, 6).size(), 4);
}

TEST(KnotVector, OpenKnotsKeepTheirDomain) {
  const KnotVector t(2, {-2, -1, 0, 0, 1, 2, 3, 4});  // the domain's first knot doubled inwards
  EXPECT_FALSE(t.is_clamped());
  EXPECT_EQ(t.first(), 0);
  EXPECT_EQ(t.last(), 2);
  EXPECT_EQ(t.interior(), (Numbers{1}));
  EXPECT_EQ(t.breaks(), (Numbers{0, 1, 2}));
  EXPECT_EQ(t.find_span(0), 3);
  EXPECT_EQ(t.find_span(2), 4);
}

TEST(KnotVector, SpansAreHalfOpenAndTheLastOneClosed) {
  const KnotVector t = KnotVector::clamped(2, Numbers{0.25, 0.5, 0.5});
  EXPECT_EQ(t.find_span(0), 2);
  EXPECT_EQ(t.find_span(std::nextafter(0.25, 0.0)), 2);
  EXPECT_EQ(t.find_span(0.25), 3);
  EXPECT_EQ(t.find_span(0.5), 5);
  EXPECT_EQ(t.find_span(1), 5);
}

TEST(KnotVector, ParametersOutsideBelongToTheEndSpans) {
  const KnotVector t = KnotVector::uniform(3, 4);
  EXPECT_EQ(t.find_span(-7), t.find_span(0));
  EXPECT_EQ(t.find_span(7), t.find_span(1));
  EXPECT_EQ(t.find_span(-kInf), t.find_span(0));
  EXPECT_EQ(t.find_span(kInf), t.find_span(1));
  const Index span = t.find_span(kNan);
  EXPECT_TRUE(span >= t.degree() && span < t.size());
}

TEST(KnotVector, FindsTheSpanThatTryingAllFinds) {
  Random random;
  for (int k = 0; k < 300; ++k) {
    const KnotVector t = random_knots(random, random.integer(1, kMaxDegree));
    for (double x : t.knots()) EXPECT_EQ(t.find_span(x), reference_span(t, x));
    for (int l = 0; l < 20; ++l) {
      const double x = random.uniform(t.knots().front() - 1, t.knots().back() + 1);
      EXPECT_EQ(t.find_span(x), reference_span(t, clamp_to(t, x)));
    }
  }
}

TEST(KnotVector, CountsItsSpansAndInteriorKnots) {
  Random random;
  for (int k = 0; k < 300; ++k) {
    const KnotVector t = random_knots(random, random.integer(1, kMaxDegree));
    EXPECT_EQ(t.span_count() + 1, static_cast<Index>(t.breaks().size()));
    Index interior = 0;
    for (double x : t.breaks())
      if (x != t.first() && x != t.last()) interior += t.multiplicity(x);
    EXPECT_EQ(interior, static_cast<Index>(t.interior().size()));
    if (t.is_clamped()) {
      EXPECT_EQ(KnotVector::clamped(t.degree(), t.interior(), t.first(), t.last()), t);
    }
  }
}

// The mean of p knots, each of size at most M: offsets and their mean round at M eps each.
TEST(KnotVector, GrevilleAbscissaeAreTheMeansOfTheKnots) {
  Random random;
  for (int k = 0; k < 200; ++k) {
    const KnotVector t = random_knots(random, random.integer(1, kMaxDegree));
    const double size = std::max(std::abs(t.knots().front()), std::abs(t.knots().back()));
    const Numbers greville = t.greville();
    ASSERT_EQ(static_cast<Index>(greville.size()), t.size());
    for (Index i = 0; i < t.size(); ++i) {
      Long mean = 0;
      for (int l = 1; l <= t.degree(); ++l) mean += t[i + l];
      EXPECT_NEAR(greville[i], static_cast<double>(mean / t.degree()), 4 * kEps * size);
    }
    if (t.is_clamped()) {
      EXPECT_EQ(greville.front(), t.first());
      EXPECT_EQ(greville.back(), t.last());
    }
  }
}

TEST(KnotVectorMerge, RefusesOtherDegreesAndDomains) {
  const KnotVector a = KnotVector::uniform(2, 1);
  expect_throw<InvalidInput>([&] { merge(a, KnotVector::uniform(3, 1)); },
                             "degrees 2 and 3 cannot be merged");
  expect_throw<InvalidInput>([&] { merge(a, KnotVector::uniform(2, 1, 0, 2)); },
                             "domains [0, 1] and [0, 2] cannot be merged");
  expect_throw<InvalidInput>(
      [&] {
        merge(a, KnotVector(2, {-2, -1, 0, 1, 2, 3}));
      },
      "different knots outside their domain cannot be merged; clamp both");
}

TEST(KnotVectorMerge, MergesOpenVectorsWithTheSameEnds) {
  const KnotVector a(1, {-1, 0, 0.5, 1, 2}), b(1, {-1, 0, 0.25, 0.5, 0.5, 1, 2});
  EXPECT_EQ(merge(a, b).knots(), (Numbers{-1, 0, 0.25, 0.5, 0.5, 1, 2}));
}

RC_GTEST_PROP(KnotVectorMerge, TakesTheLargerMultiplicity, ()) {
  const KnotVector a = *clamped_knots();
  const KnotVector other = *clamped_knots();
  std::vector<double> interior;  // of the same degree
  for (double x : other.interior())
    if (std::count(interior.begin(), interior.end(), x) <= a.degree()) interior.push_back(x);
  const KnotVector b = KnotVector::clamped(a.degree(), interior), both = merge(a, b);
  RC_ASSERT(both == merge(b, a));
  RC_ASSERT(merge(a, a) == a);
  for (int k = 0; k <= 16; ++k)
    RC_ASSERT(both.multiplicity(k / 16.0) == std::max(a.multiplicity(k / 16.0), b.multiplicity(k / 16.0)));
}

}  // namespace
}  // namespace knotfit::test
