#include "fit/knot_loss.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/surface.h"
#include "support/dense_reference.h"
#include "support/random_splines.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

/// Interior knots with doubles and, from degree 3, a triple among them.
InteriorKnots some_knots(int degree) {
  InteriorKnots knots{{0.15, 0.3, 0.5, 0.5, 0.8}, {0.2, 0.45, 0.6, 0.9}};
  if (degree < 2) knots.u = {0.15, 0.3, 0.5, 0.8};
  if (degree > 2) knots.v = {0.2, 0.6, 0.6, 0.6, 0.9};
  return knots;
}

TEST(KnotFunctional, VanishesOnSplinesWithoutTheKnot) {
  Random random;
  for (int degree = 1; degree <= 5; ++degree)
    for (const std::vector<double>& interior : {some_knots(degree).u, some_knots(degree).v})
      for (std::size_t l = 0; l < interior.size(); ++l) {
        std::vector<double> rest = interior;
        rest.erase(rest.begin() + static_cast<Index>(l));
        const KnotVector without = KnotVector::clamped(degree, rest), line = KnotVector::uniform(1, 0);
        const Surface s(without, line, 1, random_numbers(random, without.size() * 2));
        const Surface refined = insert_knot_u(s, interior[l]);
        const KnotFunctional f =
            knot_functional(KnotVector::clamped(degree, interior), static_cast<Index>(l));
        double sum = 0, most = 0;
        for (std::size_t i = 0; i < f.entry.size(); ++i) {
          sum += f.entry[i] * refined.net()[(f.first + static_cast<Index>(i)) * 2];
          most = std::max(most, std::abs(f.entry[i]));
        }
        EXPECT_NEAR(sum, 0, 1e-13);
        EXPECT_EQ(most, 1);
      }
}

TEST(KnotLosses, AreTheRiseOfTheSquaresWithoutEachKnot) {
  Random random;
  LeastSquaresOptions options;
  options.smoothing = 0;
  options.refinement_steps = 0;
  options.use_grid = false;
  for (int degree = 1; degree <= 4; ++degree)
    for (int dimension : {1, 3})
      for (bool swapped : {false, true}) {
        const ParameterizedPoints points = random_points(random, 900, dimension, dimension == 3);
        InteriorKnots knots = some_knots(degree);
        if (swapped) std::swap(knots.u, knots.v);
        MovingFit problem(points, degree, degree, options);
        for (bool along_v : {false, true}) {
          ASSERT_TRUE(problem.solve(knots));
          const double phi = problem.phi();
          const std::vector<double> losses = knot_losses(problem, along_v);
          const auto& line = along_v ? knots.v : knots.u;
          ASSERT_EQ(losses.size(), line.size());
          for (std::size_t l = 0; l < line.size(); ++l) {
            InteriorKnots without = knots;
            auto& rest = along_v ? without.v : without.u;
            rest.erase(rest.begin() + static_cast<Index>(l));
            ASSERT_TRUE(problem.solve(without));
            EXPECT_NEAR(losses[l], problem.phi() - phi, 1e-9 * phi) << degree << " knot " << l;
          }
        }
      }
}

}  // namespace
}  // namespace knotfit::test
