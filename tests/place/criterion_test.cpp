// The cell criterion and its descent [Zhang16; METHOD 2.2] against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
#include "knotfit/place.h"
#include "place/shares.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

FeatureMap random_map(Random& random, Index size_u, Index size_v) {
  FeatureMap map{size_u, size_v, {}};
  for (Index c = 0; c < size_u * size_v; ++c) map.f.push_back(random.log_uniform(1e-3, 1));
  return map;
}

std::vector<double> random_places(Random& random, int count) {
  std::vector<double> knots;
  for (int k = 0; k < count; ++k) knots.push_back(random.uniform(0.01, 0.99));
  std::sort(knots.begin(), knots.end());
  return knots;
}

/// E by its definition: every cell of the knots against every cell of the map.
double brute_force(const FeatureMap& map, const InteriorKnots& knots) {
  const std::vector<double> u = with_ends(knots.u), v = with_ends(knots.v);
  auto overlap = [](double a0, double a1, Index i, Index size) {
    const double n = static_cast<double>(size), low = static_cast<double>(i) / n,
                 high = static_cast<double>(i + 1) / n;
    return std::max(0.0, std::min(a1, high) - std::max(a0, low));
  };
  double total = 0, energy = 0;
  for (double f : map.f) total += f / static_cast<double>(map.size_u * map.size_v);
  for (std::size_t i = 0; i + 1 < u.size(); ++i)
    for (std::size_t j = 0; j + 1 < v.size(); ++j) {
      double share = 0;
      for (Index a = 0; a < map.size_u; ++a)
        for (Index b = 0; b < map.size_v; ++b)
          share += map.f[a * map.size_v + b] * overlap(u[i], u[i + 1], a, map.size_u) *
                   overlap(v[j], v[j + 1], b, map.size_v);
      energy += share / total * (share / total);
    }
  return energy;
}

TEST(Criterion, IsTheSumOfSquaredShares) {
  Random random;
  for (int k = 0; k < 60; ++k) {
    const FeatureMap map = random_map(random, random.integer(1, 12), random.integer(1, 12));
    const InteriorKnots knots{random_places(random, random.integer(0, 5)),
                              random_places(random, random.integer(0, 5))};
    EXPECT_NEAR(cell_criterion(map, knots), brute_force(map, knots), 1e-12);
  }
}

TEST(Criterion, DoesNotDependOnTheScaleOfF) {
  Random random;
  FeatureMap map = random_map(random, 9, 7);
  const InteriorKnots knots{{0.3, 0.6}, {0.5}};
  const double energy = cell_criterion(map, knots);
  for (double& f : map.f) f *= 1e-8;
  EXPECT_NEAR(cell_criterion(map, knots), energy, 1e-14);
}

TEST(Criterion, OfNoFeaturesIsZero) {
  const FeatureMap nothing{4, 4, std::vector<double>(16, 0.0)};
  EXPECT_EQ(cell_criterion(nothing, {{0.5}, {0.5}}), 0);
  const Placement placement = descend_criterion(nothing, {{0.5}, {0.2, 0.7}});
  EXPECT_EQ(placement.knots, (InteriorKnots{{0.5}, {0.2, 0.7}}));
  EXPECT_EQ(placement.status, PlacementStatus::converged);
}

TEST(Descent, NeverRaisesE) {
  Random random;
  for (int k = 0; k < 50; ++k) {
    const FeatureMap map = random_map(random, random.integer(2, 30), random.integer(2, 30));
    InteriorKnots knots{random_places(random, random.integer(0, 8)),
                        random_places(random, random.integer(0, 8))};
    double before = cell_criterion(map, knots);
    for (int sweep = 0; sweep < 30; ++sweep) {
      const Placement placement = descend_criterion(map, knots, 0, 1);
      EXPECT_NEAR(placement.criterion_start, before, 1e-13);
      EXPECT_LE(placement.criterion, placement.criterion_start);
      EXPECT_EQ(cell_criterion(map, placement.knots), placement.criterion);
      for (const auto* line : {&placement.knots.u, &placement.knots.v})
        EXPECT_TRUE(std::is_sorted(line->begin(), line->end(), std::less_equal<double>()));  // strictly
      before = placement.criterion;
      knots = placement.knots;
    }
  }
}

TEST(Descent, EndsWhereNoSingleKnotLowersE) {
  Random random;
  for (int k = 0; k < 25; ++k) {
    const FeatureMap map = random_map(random, random.integer(2, 12), random.integer(2, 12));
    const Placement placement = descend_criterion(
        map, {random_places(random, random.integer(1, 4)), random_places(random, random.integer(1, 4))}, 0,
        100000);
    ASSERT_EQ(placement.status, PlacementStatus::converged);
    for (bool v : {false, true}) {
      const std::vector<double> breaks = with_ends(v ? placement.knots.v : placement.knots.u);
      for (std::size_t i = 1; i + 1 < breaks.size(); ++i)
        for (int step = 1; step < 500; ++step) {
          InteriorKnots moved = placement.knots;
          (v ? moved.v : moved.u)[i - 1] = breaks[i - 1] + (breaks[i + 1] - breaks[i - 1]) * step / 500;
          EXPECT_GE(cell_criterion(map, moved), placement.criterion * (1 - 1e-12));
        }
    }
  }
}

TEST(Descent, FindsTheUniformKnotsOfConstantF) {
  Random random;
  const FeatureMap map{20, 33, std::vector<double>(20 * 33, 2.0)};
  for (int k = 0; k < 10; ++k) {
    const int p = random.integer(0, 6), q = random.integer(0, 6);
    const Placement placement =
        descend_criterion(map, {random_places(random, p), random_places(random, q)}, 1e-10, 100000);
    EXPECT_EQ(placement.status, PlacementStatus::converged);
    // E is flat there: moves that gain less than its rounding, 1e-14, are not made.
    for (int i = 0; i < p; ++i) EXPECT_NEAR(placement.knots.u[i], (i + 1.0) / (p + 1), 1e-6);
    for (int j = 0; j < q; ++j) EXPECT_NEAR(placement.knots.v[j], (j + 1.0) / (q + 1), 1e-6);
    EXPECT_NEAR(placement.criterion, 1.0 / ((p + 1) * (q + 1)), 1e-12);
  }
}

TEST(Descent, FindsTheEqualSharesOfSeparableF) {
  // E = (sum_i G_i^2)(sum_j H_j^2) for f = g(u) h(v): least where every share is the same.
  Random random;
  for (int k = 0; k < 10; ++k) {
    std::vector<double> g, h;
    for (int i = 0; i < 40; ++i) g.push_back(random.log_uniform(0.05, 1));
    for (int j = 0; j < 25; ++j) h.push_back(random.log_uniform(0.05, 1));
    FeatureMap map{40, 25, {}};
    for (double a : g)
      for (double b : h) map.f.push_back(a * b);
    const int p = random.integer(1, 5), q = random.integer(1, 5);
    const InteriorKnots shares = equal_share(map, p, q);
    EXPECT_NEAR(cell_criterion(map, shares), 1.0 / ((p + 1) * (q + 1)), 1e-12);
    const Placement from_shares = descend_criterion(map, shares);
    for (int i = 0; i < p; ++i) EXPECT_NEAR(from_shares.knots.u[i], shares.u[i], 1e-6);
    const Placement placement =
        descend_criterion(map, {random_places(random, p), random_places(random, q)}, 1e-11, 100000);
    for (int i = 0; i < p; ++i) EXPECT_NEAR(placement.knots.u[i], shares.u[i], 1e-6);
    for (int j = 0; j < q; ++j) EXPECT_NEAR(placement.knots.v[j], shares.v[j], 1e-6);
  }
}

TEST(Descent, LowersTheMarginalSharesWhereFIsNotSeparable) {
  // f along the diagonal: shares of the marginals are uniform, and not the best.
  FeatureMap map{60, 60, std::vector<double>(3600, 0.01)};
  for (Index i = 0; i < 60; ++i) map.f[i * 60 + i] = map.f[i * 60 + i / 2] = 1;
  const Placement placement = descend_criterion(map, equal_share(map, 4, 4));
  EXPECT_LT(placement.criterion, 0.95 * placement.criterion_start);
}

TEST(Descent, SaysWhetherItConverged) {
  Random random;
  const FeatureMap map = random_map(random, 30, 30);
  const InteriorKnots start{random_places(random, 6), random_places(random, 6)};
  const Placement none = descend_criterion(map, start, 1e-5, 0);
  EXPECT_EQ(none.status, PlacementStatus::limit);
  EXPECT_EQ(none.knots, start);
  EXPECT_EQ(none.criterion, none.criterion_start);
  EXPECT_EQ(descend_criterion(map, start, 1e-5, 1).status, PlacementStatus::limit);
  EXPECT_EQ(descend_criterion(map, start, 1e-5, 10000).status, PlacementStatus::converged);
}

TEST(EqualShare, CutsTheMarginalsIntoEqualParts) {
  Random random;
  for (int k = 0; k < 20; ++k) {
    FeatureMap map = random_map(random, 15, 10);
    const InteriorKnots knots = equal_share(map, 4, 3);
    // A strip between two knots is a cell where the other direction has none: E of equal shares is 1/n.
    EXPECT_NEAR(cell_criterion(map, {knots.u, {}}), 1.0 / 5, 1e-12);
    EXPECT_NEAR(cell_criterion(map, {{}, knots.v}), 1.0 / 4, 1e-12);
  }
}

TEST(EqualShare, OfNoFeaturesIsUniform) {
  const FeatureMap nothing{5, 5, std::vector<double>(25, 0.0)};
  EXPECT_EQ(equal_share(nothing, 3, 1), (InteriorKnots{{0.25, 0.5, 0.75}, {0.5}}));
}

TEST(EqualShare, KeepsKnotsApartWhereAllFeaturesAreInOneCell) {
  FeatureMap map{200, 200, std::vector<double>(40000, 0.0)};
  map.f[200 * 77 + 150] = 1;
  const InteriorKnots knots = equal_share(map, 9, 9);
  for (const auto* line : {&knots.u, &knots.v}) {
    const std::vector<double> breaks = with_ends(*line);
    for (std::size_t s = 0; s + 1 < breaks.size(); ++s) EXPECT_GE(breaks[s + 1] - breaks[s], 0.99e-3);
  }
}

TEST(Criterion, RefusesBadMapsAndKnots) {
  const FeatureMap good{2, 2, {1, 1, 1, 1}};
  FeatureMap bad = good;
  bad.f[3] = -1;
  expect_throw<InvalidInput>(
      [&] {
        cell_criterion(bad, {{0.5}, {}});
      },
      "the feature measure of cell (1, 1) is -1");
  expect_throw<InvalidInput>([&] { descend_criterion(bad, {{0.5}, {}}); }, "cell (1, 1)");
  bad.f[3] = std::numeric_limits<double>::quiet_NaN();
  expect_throw<InvalidInput>([&] { equal_share(bad, 1, 1); }, "cell (1, 1)");
  for (const InteriorKnots& knots :
       {InteriorKnots{{0.0}, {}}, InteriorKnots{{}, {1.0}}, InteriorKnots{{0.5, 0.5}, {}},
        InteriorKnots{{}, {0.6, 0.5}}, InteriorKnots{{std::numeric_limits<double>::quiet_NaN()}, {}}}) {
    expect_throw<InvalidInput>([&] { cell_criterion(good, knots); }, "increase strictly within (0,1)");
    expect_throw<InvalidInput>([&] { descend_criterion(good, knots); }, "increase strictly within (0,1)");
  }
  expect_throw<InvalidInput>([&] { equal_share(good, -1, 2); }, "neither may be negative");
}

}  // namespace
}  // namespace knotfit::test
