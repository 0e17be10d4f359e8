#include "correct/map_hold.h"

#include <gtest/gtest.h>

#include <numbers>

#include "correct/flat_mesh.h"
#include "support/random_splines.h"
namespace knotfit::correction {
namespace {

using namespace knotfit::test;

/// (x(u), y, 0) with the control points' x by their place.
Surface strip(const KnotVector& u, const KnotVector& v, const std::vector<double>& x) {
  std::vector<double> net;
  for (const double a : x)
    for (const double b : v.greville()) net.insert(net.end(), {a, b, 0});
  return Surface(u, v, 3, net);
}

TEST(GradientData, AreTheDerivativesOfTheMap) {
  const KnotVector u = KnotVector::uniform(3, 3), v = KnotVector::uniform(3, 1);
  const SpanTable tu(u), tv(v);
  const std::vector<GradientDatum> data = gradient_data(flat(5, 3, 2), tu, tv, 1e-2);
  double sum_u = 0;
  std::size_t inside = 0;
  for (const GradientDatum& g : data) {
    if (g.weight_u > 0) {
      EXPECT_NEAR(length(g.xu - Vec3{3, 0, 0}), 0, 1e-12);
    }
    if (g.weight_v > 0) {
      EXPECT_NEAR(length(g.xv - Vec3{0, 2, 0}), 0, 1e-12);
    }
    if (g.weight_u > 0 && g.weight_v > 0) sum_u += g.weight_u, ++inside;
  }
  EXPECT_EQ(inside, 3u * 4 * 3 * 2);
  EXPECT_NEAR(sum_u, 1e-2 / 16, 1e-12);  // eps h_u^2
  EXPECT_EQ(data.size(), inside + 2 * (3 * 4 + 3 * 2));
  EXPECT_TRUE(gradient_data(flat(5), tu, tv, 0).empty());
}

TEST(Reference, KnowsTheCurvatureOfTheMesh) {
  // A piece of a cylinder of radius 2 about the y axis, u along its arc, v along the axis.
  HoldingMesh m = flat(60);
  for (Index k = 0; k < m.size(); ++k) {
    const double turn = m.uv[2 * k] / 2;
    m.position[k] = {2 * std::sin(turn), m.uv[2 * k + 1], 2 * std::cos(turn)};
  }
  const SpanTable t(KnotVector::uniform(3, 7));
  const Reference r = reference(m, t, t, 1);
  for (Index i = 0; i < 32; ++i)
    for (Index j = 0; j < 32; ++j) {
      const auto bend = curvature_at(r, i, j);
      ASSERT_TRUE(bend);
      EXPECT_NEAR((*bend)[0], -0.5, 0.05);  // |X_uu| = 1 / 2, against the outward normal
      EXPECT_NEAR((*bend)[1], 0, 0.01);
      EXPECT_NEAR((*bend)[2], 0, 0.01);
    }
}

/// (u, v, height) over a flat mesh, the control points' heights alternating along u.
Surface waves(const KnotVector& knots, double height) {
  std::vector<double> net;
  int k = 0;
  for (const double a : knots.greville()) {
    ++k;
    for (const double b : knots.greville()) net.insert(net.end(), {a, b, k % 2 == 0 ? height : -height});
  }
  return Surface(knots, knots, 3, net);
}

TEST(CurvatureData, StandsWhereTheNormalsAreFarOff) {
  const KnotVector knots = KnotVector::uniform(3, 7);
  const std::vector<double> weights(64, 1.0);
  constexpr double fairness = 1e-2;
  const auto data = [&](double height, double weight) {
    const CellPolynomials cells(waves(knots, height));
    return hinge_rows(cells, reference(flat(9), cells.u(), cells.v(), 1), weights, weight).curvature;
  };
  EXPECT_TRUE(data(0.2, 0).empty());
  EXPECT_TRUE(data(0.002, fairness).empty());  // nowhere 15 degrees
  const CellPolynomials cells(waves(knots, 0.2));
  const std::vector<CurvatureDatum> all = data(0.2, fairness);
  ASSERT_FALSE(all.empty());
  std::size_t full = 0;
  for (const CurvatureDatum& d : all) {
    const Jet j = cells.jet(d.u, d.v);
    const double angle = std::acos(unit(cross(j.u, j.v)).z) * 180 / std::numbers::pi;
    EXPECT_GT(angle, 15);
    const double whole = fairness / (32 * 32) / std::pow(8.0, 4);
    EXPECT_NEAR(d.weight[0], whole * std::min(1.0, (angle - 15) / 10), 1e-9 * whole);
    EXPECT_NEAR(d.weight[1], 2 * d.weight[0], 1e-9 * whole);
    EXPECT_NEAR(d.weight[2], d.weight[0], 1e-9 * whole);
    for (const double target : d.target) EXPECT_NEAR(target, 0, 1e-9);
    if (angle > 25) ++full;
  }
  EXPECT_GT(full, 0u);
}

TEST(HingeRows, AreNoneWhereTheSurfaceFollowsTheMesh) {
  const KnotVector knots = KnotVector::uniform(3, 4);
  const HoldingMesh m = flat(8);
  const Surface s = strip(knots, knots, knots.greville());
  const CellPolynomials cells(s);
  for (const double aspect : {1.0, 2.5}) {
    const Reference r = reference(m, cells.u(), cells.v(), aspect);
    EXPECT_NEAR(r.mean_area, 1, 1e-12);
    const HingeState state = hinge_rows(cells, r, std::vector<double>(25, 1.0));
    EXPECT_EQ(state.folded, 0);
    EXPECT_TRUE(state.rows.empty());
  }
}

TEST(HingeRows, AskForTheSingularValueTheyStandFor) {
  // x(u) creeps, turns back and races: singular values below 0.5, negative, and above 2.
  const KnotVector knots = KnotVector::uniform(3, 7);
  std::vector<double> x = knots.greville();
  x[4] = x[3] + 0.01, x[5] = x[4] - 0.05, x[6] = x[5] + 0.5;
  const Surface s = strip(knots, knots, x);
  const CellPolynomials cells(s);
  const Reference r = reference(flat(9), cells.u(), cells.v(), 1);
  const HingeState state = hinge_rows(cells, r, std::vector<double>(64, 2.0));
  EXPECT_GT(state.folded, 0);
  bool low = false, high = false, turned = false;
  for (const HingeRow& h : state.rows) {
    const Jet j = cells.jet(h.u, h.v);
    const double value = dot(h.y, h.a * j.u + h.b * j.v);
    // y and z are +-e_u: the value is S_u's share along the mesh.
    EXPECT_NEAR(value, dot(j.u, {1, 0, 0}), 1e-9);
    EXPECT_TRUE(h.target == 0.5 ? value < 0.5 : value > 2);
    EXPECT_NEAR(h.weight, 2 * 3e-2 / 64 / 64 / 16, 1e-12);
    low = low || h.target == 0.5;
    high = high || h.target == 2;
    turned = turned || value < 0;
  }
  EXPECT_TRUE(low && high && turned);
  double folded = 0;
  for (int c = 0; c < 64; ++c) folded += state.cell_folds[c] ? 1.0 / 64 : 0;
  EXPECT_LE(state.folded, folded);
  EXPECT_EQ(hinge_rows(cells, r, {}).folded, state.folded);
}

TEST(HingeRows, DoNotDependOnHowTheSquareLies) {
  // The same mesh and surface with space turned: the same rows up to the turn.
  Random random;
  const KnotVector knots = KnotVector::uniform(3, 3);
  std::vector<double> net = random_numbers(random, 49 * 3, 0.2);
  const std::vector<double> g = knots.greville();
  for (int k = 0; k < 49; ++k) net[3 * k] += g[k / 7], net[3 * k + 1] += g[k % 7];
  HoldingMesh m = flat(7);
  const Surface s(knots, knots, 3, net);
  std::vector<double> turned;
  for (int k = 0; k < 49; ++k) turned.insert(turned.end(), {-net[3 * k + 1], net[3 * k], net[3 * k + 2]});
  const CellPolynomials a(s), b(Surface(knots, knots, 3, turned));
  const HingeState one = hinge_rows(a, reference(m, a.u(), a.v(), 1.4), std::vector<double>(16, 1.0));
  for (Vec3& p : m.position) p = {-p.y, p.x, p.z};
  const HingeState two = hinge_rows(b, reference(m, b.u(), b.v(), 1.4), std::vector<double>(16, 1.0));
  ASSERT_GT(one.rows.size(), 0u);
  ASSERT_EQ(one.rows.size(), two.rows.size());
  EXPECT_NEAR(one.folded, two.folded, 1e-12);
  for (std::size_t k = 0; k < one.rows.size(); ++k) {
    const Jet j = a.jet(one.rows[k].u, one.rows[k].v), l = b.jet(two.rows[k].u, two.rows[k].v);
    EXPECT_NEAR(dot(one.rows[k].y, one.rows[k].a * j.u + one.rows[k].b * j.v),
                dot(two.rows[k].y, two.rows[k].a * l.u + two.rows[k].b * l.v), 1e-9);
  }
}

}  // namespace
}  // namespace knotfit::correction
