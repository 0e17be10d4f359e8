#include "fit/knot_basis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/knot_jacobian.h"
#include "knotfit/basis.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

/// All functions at a place, 0 where they are not alive.
std::vector<double> functions_at(const Axis& axis, double x) {
  const KnotVector& knots = axis.knots();
  const Index span = knots.find_span(x);
  std::vector<double> alive(static_cast<std::size_t>(axis.width())),
      all(static_cast<std::size_t>(axis.functions()), 0.0);
  basis_functions(knots, span, x, alive);
  for (int i = 0; i < axis.width(); ++i) all[span - axis.degree() + i] = alive[i];
  return all;
}

TEST(KnotBasis, AgreesWithTheBasisAndItsDifferencesInTheKnots) {
  Random random;
  for (const int degree : {1, 2, 3, 5}) {
    const std::vector<double> interior{0.2, 0.35, 0.5, 0.62, 0.8};
    const Axis axis(degree, interior);
    const std::vector<double> derivatives = knot_derivatives(axis);
    KnotBasis at;  // one for all places: each sets it anew
    for (int repeat = 0; repeat < 30; ++repeat) {
      const double x = random.unit();
      bool near_a_knot = false;
      for (const double knot : interior) near_a_knot = near_a_knot || std::abs(x - knot) < 1e-3;
      if (near_a_knot) continue;
      at.set(axis, derivatives, x);
      const std::vector<double> values = functions_at(axis, x);
      for (int i = 0; i <= degree; ++i) EXPECT_NEAR(at.value[i], values[at.span + i], 1e-13);
      for (int e = 0; e < 2 * degree; ++e) {
        const Index knot = at.span - degree + e;
        if (knot < 0 || knot >= static_cast<Index>(interior.size())) continue;
        constexpr double h = 1e-5;
        std::vector<double> up = interior, down = interior;
        up[knot] += h, down[knot] -= h;
        const std::vector<double> more = functions_at(Axis(degree, up), x),
                                  less = functions_at(Axis(degree, down), x);
        // Of a central difference: h^2 / 6 of the third derivative, some (degree / span)^3 = 1e5 here.
        for (int i = 0; i <= degree; ++i)
          EXPECT_NEAR(at.by_knot[e][i], (more[at.span + i] - less[at.span + i]) / (2 * h), 1e-5)
              << "degree " << degree << " at " << x << ", knot " << knot;
      }
    }
  }
}

TEST(KnotBasis, WithoutTablesLeavesTheKnotsAlone) {
  const std::vector<double> interior{0.5};
  KnotBasis at;
  at.by_knot[0][0] = 7;
  at.set(Axis(3, interior), {}, 0.25);
  EXPECT_EQ(at.by_knot[0][0], 7);
  EXPECT_DOUBLE_EQ(at.value[0], 0.125);
}

}  // namespace
}  // namespace knotfit::test
