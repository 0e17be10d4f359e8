#include "nearest/cell_polynomials.h"

#include <gtest/gtest.h>

#include "knotfit/evaluate.h"
#include "support/random_splines.h"
namespace knotfit {
namespace {

using namespace knotfit::test;

std::vector<double> random_places(Random& random, const Surface& s, int count) {
  std::vector<double> uv;
  for (int k = 0; k < count; ++k) {
    uv.push_back(random_parameter(random, s.knots_u()));
    uv.push_back(random_parameter(random, s.knots_v()));
  }
  for (double u : {s.knots_u().first(), s.knots_u().last()})
    for (double v : {s.knots_v().first(), s.knots_v().last()}) uv.insert(uv.end(), {u, v});
  return uv;
}

// A power basis of degree p on [-1,1] has coefficients up to about (1 + sqrt 2)^p of the values; the
// derivative is 2 / h times that of the local coordinate, and grows by p^2.
double rounding(const Surface& s, double shortest) {
  return std::pow(1 + std::sqrt(2.0), s.degree_u() + s.degree_v()) * 64 * kEps * s.scale() / shortest;
}

double shortest_span(const SpanTable& t) {
  double shortest = INFINITY;
  for (Index k = 0; k < t.spans(); ++k) shortest = std::min(shortest, t.length(k));
  return shortest;
}

TEST(CellPolynomials, AgreeWithEvaluation) {
  Random random;
  for (int repeat = 0; repeat < 60; ++repeat) {
    const Surface s = random_surface(random, 3);
    const CellPolynomials cells(s);
    const std::vector<double> uv = random_places(random, s, 40);
    std::vector<Jet> jets(uv.size() / 2);
    cells.jets(uv, jets.data());
    const double shortest = std::min({1.0, shortest_span(cells.u()), shortest_span(cells.v())});
    for (std::size_t k = 0; k < jets.size(); ++k) {
      const std::vector<double> d = evaluate_derivatives(s, uv[2 * k], uv[2 * k + 1], 2);
      SecondDerivatives second;
      const Jet j = cells.jet(uv[2 * k], uv[2 * k + 1], second);
      const auto expect = [&](const Vec3& got, int a, int b, double bound) {
        EXPECT_NEAR(length(got - at(&d[(3 * a + b) * 3])), 0, bound) << a << b << " repeat " << repeat;
      };
      expect(jets[k].s, 0, 0, rounding(s, 1));
      expect(j.s, 0, 0, rounding(s, 1));
      expect(jets[k].u, 1, 0, 100 * rounding(s, shortest));
      expect(jets[k].v, 0, 1, 100 * rounding(s, shortest));
      expect(j.u, 1, 0, 100 * rounding(s, shortest));
      expect(j.v, 0, 1, 100 * rounding(s, shortest));
      expect(second.uu, 2, 0, 1e4 * rounding(s, shortest * shortest));
      expect(second.uv, 1, 1, 1e4 * rounding(s, shortest * shortest));
      expect(second.vv, 0, 2, 1e4 * rounding(s, shortest * shortest));
    }
  }
}

TEST(CellPolynomials, APlaceHasTheSameBitsWhateverItsNeighbours) {
  Random random;
  for (int repeat = 0; repeat < 20; ++repeat) {
    const Surface s = random_surface(random, 3);
    const CellPolynomials cells(s);
    const std::vector<double> uv = random_places(random, s, 200);
    const std::vector<std::int32_t> order = order_by_cell(cells, uv);
    std::vector<double> sorted;
    for (const std::int32_t k : order) sorted.insert(sorted.end(), {uv[2 * k], uv[2 * k + 1]});
    std::vector<Jet> jets(order.size());
    cells.jets(sorted, jets.data());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Jet one = cells.jet(sorted[2 * i], sorted[2 * i + 1]);
      EXPECT_EQ(length(one.s - jets[i].s), 0);
      EXPECT_EQ(length(one.u - jets[i].u), 0);
      EXPECT_EQ(length(one.v - jets[i].v), 0);
    }
    for (std::size_t i = 1; i < order.size(); ++i)
      EXPECT_LE(cells.cell(sorted[2 * i - 2], sorted[2 * i - 1]),
                cells.cell(sorted[2 * i], sorted[2 * i + 1]));
  }
}

TEST(SpanTable, FindsTheSpanOfEveryParameter) {
  Random random;
  for (int repeat = 0; repeat < 200; ++repeat) {
    const KnotVector knots = random_knots(random, random.integer(1, 5));
    const SpanTable table(knots);
    std::vector<double> places = knots.breaks();
    for (int k = 0; k < 30; ++k) places.push_back(random_parameter(random, knots));
    for (const double x : places)
      EXPECT_EQ(table.function(table.span(x)), knots.find_span(x) - knots.degree());
  }
}

}  // namespace
}  // namespace knotfit
