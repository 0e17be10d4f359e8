#include "nearest/foot_points.h"

#include <gtest/gtest.h>

#include "knotfit/threads.h"
#include "support/random_splines.h"
namespace knotfit {
namespace {

using namespace knotfit::test;

/// (x, y, height) over the unit square, gently curved.
Surface sheet(int spans, double height) {
  const KnotVector knots = KnotVector::uniform(3, spans - 1);
  const std::vector<double> g = knots.greville();
  std::vector<double> net;
  for (const double x : g)
    for (const double y : g) net.insert(net.end(), {x, y, height * std::sin(4 * x) * std::cos(3 * y)});
  return Surface(knots, knots, 3, net);
}

struct Points {
  std::vector<Vec3> p;
  std::vector<double> uv;
};

Points near(const Surface& s, Random& random, int count, double off, double along) {
  const CellPolynomials cells(s);
  Points r;
  for (int k = 0; k < count; ++k) {
    const double u = random.unit(), v = random.unit();
    r.p.push_back(cells.jet(u, v).s +
                  Vec3{random.uniform(-off, off), random.uniform(-off, off), random.uniform(-off, off)});
    r.uv.push_back(std::clamp(u + random.uniform(-along, along), 0.0, 1.0));
    r.uv.push_back(std::clamp(v + random.uniform(-along, along), 0.0, 1.0));
  }
  return r;
}

TEST(FootPoints, AreWhereTheDifferenceIsNormal) {
  Random random;
  const Surface s = sheet(7, 0.2);
  const CellPolynomials cells(s);
  Points r = near(s, random, 3000, 0.01, 0.05);
  std::vector<double> start = r.uv;
  std::vector<Jet> jets(r.p.size());
  const std::vector<double> d = foot_points(cells, r.p, {}, {.iterations = 40}, r.uv, jets);
  for (std::size_t k = 0; k < r.p.size(); ++k) {
    EXPECT_LE(d[k], squared(cells.jet(start[2 * k], start[2 * k + 1]).s - r.p[k])) << "no distance grows";
    const Vec3 e = jets[k].s - r.p[k];
    EXPECT_EQ(squared(e), d[k]);
    const double u = r.uv[2 * k], v = r.uv[2 * k + 1], gu = dot(e, jets[k].u), gv = dot(e, jets[k].v);
    // |e| is 0.02 at most and the curvature about 3: the iteration shrinks its error to a tenth a step.
    if (u > 0 && u < 1) {
      EXPECT_NEAR(gu, 0, 1e-7);
    }
    if (v > 0 && v < 1) {
      EXPECT_NEAR(gv, 0, 1e-7);
    }
    if (u == 0) {
      EXPECT_GE(gu, -1e-7);
    }
    if (u == 1) {
      EXPECT_LE(gu, 1e-7);
    }
    if (v == 0) {
      EXPECT_GE(gv, -1e-7);
    }
    if (v == 1) {
      EXPECT_LE(gv, 1e-7);
    }
  }
}

TEST(FootPoints, StayOnTheirSides) {
  Random random;
  const Surface s = sheet(5, 0.3);
  const CellPolynomials cells(s);
  Points r = near(s, random, 800, 0.05, 0);
  std::vector<Slide> slide;
  for (std::size_t k = 0; k < r.p.size(); ++k) {
    const Slide kinds[] = {Slide::free, Slide::along_v, Slide::along_u, Slide::fixed, Slide::round};
    slide.push_back(kinds[k % 5]);
    if (slide[k] == Slide::along_v || slide[k] == Slide::round) r.uv[2 * k] = k % 2 == 0 ? 0 : 1;
    if (slide[k] == Slide::along_u) r.uv[2 * k + 1] = k % 2 == 0 ? 0 : 1;
  }
  const std::vector<double> start = r.uv;
  foot_points(cells, r.p, slide, {.iterations = 20}, r.uv);
  int moved = 0;
  for (std::size_t k = 0; k < r.p.size(); ++k) {
    const double u = r.uv[2 * k], v = r.uv[2 * k + 1];
    if (slide[k] == Slide::along_v || slide[k] == Slide::fixed) {
      EXPECT_EQ(u, start[2 * k]);
    }
    if (slide[k] == Slide::along_u || slide[k] == Slide::fixed) {
      EXPECT_EQ(v, start[2 * k + 1]);
    }
    if (slide[k] == Slide::round) {
      EXPECT_TRUE(u == 0 || u == 1 || v == 0 || v == 1);
    }
    moved += u != start[2 * k] || v != start[2 * k + 1];
  }
  EXPECT_GE(moved, 600);
}

TEST(FootPoints, SlideRoundACorner) {
  const Surface s = sheet(4, 0);
  const CellPolynomials cells(s);
  // Nearest to the side v = 0 at u = 0.3; begun on the side u = 0.
  const std::vector<Vec3> p{{0.3, -0.2, 0.1}};
  std::vector<double> uv{0, 0.4};
  const std::vector<Slide> slide{Slide::round};
  const auto d = foot_points(cells, p, slide, {.iterations = 12, .longest_u = 0.25, .longest_v = 0.25}, uv);
  EXPECT_NEAR(uv[0], 0.3, 1e-12);
  EXPECT_EQ(uv[1], 0);
  EXPECT_NEAR(d[0], 0.05, 1e-12);
}

TEST(FootPoints, NoStepIsLongerThanAsked) {
  const Surface s = sheet(4, 0);
  const CellPolynomials cells(s);
  std::vector<double> uv{0.1, 0.1};
  foot_points(cells, std::vector<Vec3>{{0.9, 0.5, 0}}, {},
              {.iterations = 1, .longest_u = 0.2, .longest_v = 0.2}, uv);
  EXPECT_NEAR(uv[0], 0.3, 1e-12);
  EXPECT_NEAR(uv[1], 0.2, 1e-5);
}

TEST(FootPoints, SurviveADegenerateSurface) {
  // All of it on one line, then in one point.
  for (const double y : {1.0, 0.0}) {
    const KnotVector knots = KnotVector::uniform(3, 2);
    std::vector<double> net;
    for (const double x : knots.greville())
      for (int j = 0; j < 6; ++j) net.insert(net.end(), {x * y, 0, 0});
    const Surface s(knots, knots, 3, net);
    const CellPolynomials cells(s);
    std::vector<double> uv{0.2, 0.3};
    const auto d = foot_points(cells, std::vector<Vec3>{{0.7, 0.4, 0}}, {}, {.iterations = 9}, uv);
    EXPECT_NEAR(std::sqrt(d[0]), y == 1 ? 0.4 : std::hypot(0.7, 0.4), 1e-9);
    EXPECT_TRUE(uv[0] >= 0 && uv[0] <= 1 && uv[1] >= 0 && uv[1] <= 1);
  }
}

TEST(FootPoints, SameBitsForOneAndTwoThreads) {
  Random random;
  const Surface s = sheet(9, 0.2);
  const CellPolynomials cells(s);
  const Points r = near(s, random, 5000, 0.02, 0.1);
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2}) {
    set_thread_count(threads);
    std::vector<double> uv = r.uv;
    std::vector<double> d = foot_points(cells, r.p, {}, {.longest_u = 0.1, .longest_v = 0.1}, uv);
    d.insert(d.end(), uv.begin(), uv.end());
    results.push_back(d);
  }
  set_thread_count(0);
  EXPECT_EQ(results[0], results[1]);
}

TEST(FootPoints, NewtonGoesToRounding) {
  Random random;
  const Surface s = sheet(6, 0.3);
  const CellPolynomials cells(s);
  const Points r = near(s, random, 300, 0.05, 0.05);
  for (std::size_t k = 0; k < r.p.size(); ++k) {
    double uv[2] = {r.uv[2 * k], r.uv[2 * k + 1]};
    const double d = polish(cells, r.p[k], uv);
    const Jet j = cells.jet(uv[0], uv[1]);
    EXPECT_EQ(squared(j.s - r.p[k]), d);
    // The distance is even to second order in the parameters: it is right to rounding, they to its root.
    if (uv[0] > 0 && uv[0] < 1) {
      EXPECT_NEAR(dot(j.s - r.p[k], j.u), 0, 3e-8);
    }
    if (uv[1] > 0 && uv[1] < 1) {
      EXPECT_NEAR(dot(j.s - r.p[k], j.v), 0, 3e-8);
    }
  }
}

}  // namespace
}  // namespace knotfit
