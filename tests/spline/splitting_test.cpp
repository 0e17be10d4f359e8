#include "spline/splitting.h"

#include <gtest/gtest.h>

#include "spline/clamped.h"
#include "spline/elevation.h"
#include "support/random_splines.h"
#include "support/sampling.h"
namespace knotfit::test {
namespace {

TEST(Splitting, PiecesAreTheSurface) {
  Random random;
  for (const Surface& s : random_surfaces(seed() + 3, 200, Ends::clamped)) {
    std::vector<double> cuts = s.knots_u().breaks();
    cuts.pop_back();
    if (!cuts.empty()) cuts.erase(cuts.begin());
    const double fresh = random_parameter(random, s.knots_u());
    if (fresh > s.knots_u().first() && s.knots_u().multiplicity(fresh) == 0) cuts.push_back(fresh);
    std::sort(cuts.begin(), cuts.end());
    const std::vector<Surface> pieces = split_u(s, cuts);
    ASSERT_EQ(pieces.size(), cuts.size() + 1);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const Surface& piece = pieces[k];
      EXPECT_EQ(piece.knots_u().first(), k == 0 ? s.knots_u().first() : cuts[k - 1]);
      EXPECT_EQ(piece.knots_u().last(), k == cuts.size() ? s.knots_u().last() : cuts[k]);
      EXPECT_TRUE(piece.knots_u().interior().empty());
      const double a = piece.knots_u().first(), b = piece.knots_u().last();
      for (int n = 1; n < 8; ++n) {
        const double u = a + (b - a) * n / 8, v = random_parameter(random, s.knots_v());
        if (!(u > a && u < b)) continue;
        std::vector<double> x(static_cast<std::size_t>(s.dimension())), y = x;
        evaluate(s, u, v, x);
        evaluate(piece, u, v, y);
        const double insertions = 4.0 * s.degree_u() * s.degree_u() * kEps * s.scale();
        for (int d = 0; d < s.dimension(); ++d)
          EXPECT_NEAR(x[static_cast<std::size_t>(d)], y[static_cast<std::size_t>(d)],
                      evaluation_error(s) + evaluation_error(piece) + insertions);
      }
    }
  }
}

TEST(Splitting, NeighboursShareTheirBorderUnlessTheSurfaceJumps) {
  Random random;
  const std::vector<double> interior = {0.25, 0.5, 0.5, 0.75, 0.75, 0.75};
  const KnotVector u = KnotVector::clamped(2, interior), v = KnotVector::uniform(3, 2);
  const Surface s(u, v, 3, random_numbers(random, u.size() * v.size() * 3));
  const std::vector<double> cuts = {0.25, 0.5, 0.75};
  const std::vector<Surface> p = split_u(s, cuts);
  ASSERT_EQ(p.size(), 4U);
  const auto shared = [&](std::size_t k) {
    for (Index j = 0; j < v.size(); ++j)
      for (int d = 0; d < 3; ++d)
        if (p[k].control_point(p[k].size_u() - 1, j)[d] != p[k + 1].control_point(0, j)[d]) return false;
    return true;
  };
  EXPECT_TRUE(shared(0));
  EXPECT_TRUE(shared(1));
  EXPECT_FALSE(shared(2));
}

}  // namespace
}  // namespace knotfit::test
