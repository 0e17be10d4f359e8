#include "correct/tangent_system.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "knotfit/evaluate.h"
#include "support/random_splines.h"
#include "support/two_threads.h"
namespace knotfit::correction {
namespace {

using namespace knotfit::test;

struct Problem {
  KnotVector u, v;
  std::vector<double> uv, weight;
  std::vector<Vec3> point;
  std::vector<Sym3> matrix;
  std::vector<GradientDatum> gradient;
  std::vector<HingeRow> hinge;
  std::vector<CurvatureDatum> curvature;
  Holding holding() const { return {gradient, hinge, curvature}; }
  SystemPoints points() const { return {uv, point, weight, matrix}; }
};

Vec3 random_vector(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

Problem random_problem(Random& random, int degree_u, int degree_v, int interior_u, int interior_v,
                       bool blocks) {
  const auto knots = [&](int degree, int count) {
    std::vector<double> interior;
    for (int k = 0; k < count; ++k) interior.push_back((k + random.uniform(0.2, 0.8)) / count);
    if (count > 2 && degree > 1) interior[1] = interior[0];  // a double knot
    return KnotVector::clamped(degree, interior);
  };
  Problem p{knots(degree_u, interior_u), knots(degree_v, interior_v), {}, {}, {}, {}, {}, {}, {}};
  for (int k = 0; k < 400; ++k) {
    p.uv.insert(p.uv.end(), {random.unit(), random.unit()});
    if (k % 20 == 0) p.uv[2 * k] = 1;
    p.point.push_back(random_vector(random));
    p.weight.push_back(random.uniform(0, 2));
    if (blocks)
      p.matrix.push_back(with_axis(random.uniform(0.01, 1), random.uniform(0, 1), random_vector(random)));
  }
  for (int k = 0; k < 60; ++k)
    p.gradient.push_back({random.unit(), random.unit(), random.uniform(0, 0.1), random.uniform(0, 0.1),
                          random_vector(random), random_vector(random)});
  for (int k = 0; k < 20 && blocks; ++k)
    p.curvature.push_back({random.unit(),
                           random.unit(),
                           unit(random_vector(random)),
                           {random.uniform(0, 1e-3), random.uniform(0, 1e-3), random.uniform(0, 1e-3)},
                           {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)}});
  if (blocks)
    for (int k = 0; k < 20; ++k)
      p.hinge.push_back({random.unit(), random.unit(), random.uniform(-1, 1), random.uniform(-1, 1),
                         random_vector(random), random.uniform(-1, 1), random.uniform(0, 0.1)});
  return p;
}

/// The objective without smoothing, straight from its definition.
double objective(const Problem& p, const Surface& s) {
  double sum = 0;
  const auto jet = [&](double u, double v) {
    const std::vector<double> d = evaluate_derivatives(s, u, v, 1);
    return std::array{at(&d[0]), at(&d[6]), at(&d[3])};
  };
  for (std::size_t k = 0; k < p.point.size(); ++k) {
    const Vec3 r = jet(p.uv[2 * k], p.uv[2 * k + 1])[0] - p.point[k];
    sum += p.weight[k] * dot(r, (p.matrix.empty() ? Sym3{} : p.matrix[k]) * r);
  }
  for (const GradientDatum& g : p.gradient) {
    const auto j = jet(g.u, g.v);
    sum += g.weight_u * squared(j[1] - g.xu) + g.weight_v * squared(j[2] - g.xv);
  }
  for (const HingeRow& h : p.hinge) {
    const auto j = jet(h.u, h.v);
    const double r = dot(h.y, h.a * j[1] + h.b * j[2]) - h.target;
    sum += h.weight * r * r;
  }
  for (const CurvatureDatum& g : p.curvature) {
    const std::vector<double> d = evaluate_derivatives(s, g.u, g.v, 2);
    const double r[3] = {dot(g.n, at(&d[18])) - g.target[0], dot(g.n, at(&d[12])) - g.target[1],
                         dot(g.n, at(&d[6])) - g.target[2]};
    for (int k = 0; k < 3; ++k) sum += g.weight[k] * r[k] * r[k];
  }
  return sum;
}

struct Degrees {
  int u, v, interior_u, interior_v;
};

TEST(TangentSystem, NoOtherControlPointsAreBetter) {
  Random random;
  for (const bool blocks : {true, false})
    for (const Degrees d : {Degrees{3, 3, 4, 4}, {3, 3, 2, 6}, {2, 3, 6, 1}, {1, 4, 3, 3}, {5, 2, 0, 4}}) {
      const Problem p = random_problem(random, d.u, d.v, d.interior_u, d.interior_v, blocks);
      const TangentSystem system(p.u, p.v, 1.3);
      const auto s = system.solve(p.points(), 1e-14, p.holding());
      ASSERT_TRUE(s);
      const double least = objective(p, *s);
      // A quadratic: at its minimum a step h along a control point costs h^2 times a diagonal entry, the same
      // both ways; a slope g would make the two differ by 4 g h.
      for (int k = 0; k < 40; ++k) {
        std::vector<double> net = s->net();
        const int at = random.integer(0, static_cast<int>(net.size()) - 1);
        const double h = 1e-2;
        net[at] += h;
        const double more = objective(p, Surface(p.u, p.v, 3, net));
        net[at] -= 2 * h;
        const double less = objective(p, Surface(p.u, p.v, 3, net));
        EXPECT_GE(more, least * (1 - 1e-12));
        EXPECT_GE(less, least * (1 - 1e-12));
        EXPECT_NEAR(more, less, 1e-8 * least) << at;
      }
    }
}

TEST(TangentSystem, ReproducesASplineOfItsSpace) {
  Random random;
  for (const bool blocks : {true, false}) {
    Problem p = random_problem(random, 3, 3, 3, 5, blocks);
    const Surface s(p.u, p.v, 3, random_numbers(random, p.u.size() * p.v.size() * 3));
    for (std::size_t k = 0; k < p.point.size(); ++k) {
      double x[3];
      evaluate(s, p.uv[2 * k], p.uv[2 * k + 1], x);
      p.point[k] = at(x);
    }
    const auto fitted = TangentSystem(p.u, p.v, 1).solve(p.points(), 1e-14, {});
    ASSERT_TRUE(fitted);
    for (std::size_t k = 0; k < p.point.size(); ++k) {  // where data is: a corner may have next to none
      double x[3];
      evaluate(*fitted, p.uv[2 * k], p.uv[2 * k + 1], x);
      EXPECT_NEAR(std::sqrt(p.weight[k]) * length(at(x) - p.point[k]), 0, 1e-6);
    }
  }
}

TEST(TangentSystem, SameBitsForOneAndTwoThreads) {
  Random random;
  const Problem p = random_problem(random, 3, 3, 9, 7, true);
  const TangentSystem system(p.u, p.v, 1);
  const auto [one, two] = on_one_and_two_threads([&] { return system.solve(p.points(), 1e-9, p.holding()); });
  EXPECT_EQ(one->net(), two->net());
}

TEST(TangentSystem, HasNoSolutionWithoutDataOrSmoothing) {
  const KnotVector k = KnotVector::uniform(3, 3);
  EXPECT_FALSE(TangentSystem(k, k, 1).solve({}, 0, {}));
}

TEST(TangentSystem, EnergyIsThatOfTheRectangle) {
  // Few points: the energy alone shapes the rest. The same surface with u and v exchanged and the aspect inverted.
  Random random;
  Problem p = random_problem(random, 3, 3, 4, 4, false);
  p.gradient.clear();
  p.uv.resize(20), p.point.resize(10), p.weight.resize(10);
  const auto a = TangentSystem(p.u, p.v, 2).solve(p.points(), 1e-3, {});
  for (std::size_t k = 0; k < 10; ++k) std::swap(p.uv[2 * k], p.uv[2 * k + 1]);
  const auto b = TangentSystem(p.v, p.u, 0.5).solve(p.points(), 1e-3, {});
  const auto unlike = TangentSystem(p.v, p.u, 2).solve(p.points(), 1e-3, {});
  ASSERT_TRUE(a && b && unlike);
  double difference = 0, other = 0;
  for (int k = 0; k < 100; ++k) {
    const double u = random.unit(), v = random.unit();
    double x[3], y[3], z[3];
    evaluate(*a, u, v, x);
    evaluate(*b, v, u, y);
    evaluate(*unlike, v, u, z);
    for (int d = 0; d < 3; ++d) {
      difference = std::max(difference, std::abs(x[d] - y[d]));
      other = std::max(other, std::abs(x[d] - z[d]));
    }
  }
  EXPECT_LT(difference, 1e-7);
  EXPECT_GT(other, 1e-3);
}

TEST(TangentSystem, ItsSlopeInTheKnotsIsThatOfTheSum) {
  Random random(seed());
  for (const bool swapped : {false, true}) {
    Problem p = random_problem(random, 3, 2, 2, 2, true);
    p.gradient.clear();
    p.hinge.clear();
    p.curvature.clear();
    p.u = KnotVector::clamped(3, std::vector<double>{0.2, 0.45, 0.8});
    p.v = KnotVector::clamped(
        2, swapped ? std::vector<double>{0.15, 0.3, 0.5, 0.7, 0.9} : std::vector<double>{0.4});
    const std::vector<char> all(p.point.size(), 1);
    const auto solve = [&](const std::vector<double>& knots) {
      Problem q = p;
      const Index in_u = static_cast<Index>(p.u.interior().size());
      q.u = KnotVector::clamped(3, std::span(knots).first(in_u));
      q.v = KnotVector::clamped(2, std::span(knots).subspan(in_u));
      const TangentSystem system(q.u, q.v, 1);
      return std::pair{objective(q, *system.solve(q.points(), 1e-13, {})), q};
    };
    std::vector<double> knots = p.u.interior();
    const std::vector<double> in_v = p.v.interior();
    knots.insert(knots.end(), in_v.begin(), in_v.end());
    const TangentSystem system(p.u, p.v, 1);
    const std::optional<KnotJacobian> jacobian =
        system.knot_jacobian(p.points(), 1e-13, {}, *system.solve(p.points(), 1e-13, {}), all);
    ASSERT_TRUE(jacobian);
    ASSERT_EQ(jacobian->knots, knots.size());
    // The control points minimise the sum: their own change adds nothing [Golub73]. Central differences of step h
    // err by h^2 times a third derivative, and by rounding over h.
    const double h = 1e-5;
    for (std::size_t k = 0; k < knots.size(); ++k) {
      std::vector<double> before = knots, after = knots;
      before[k] -= h;
      after[k] += h;
      const double slope = (solve(after).first - solve(before).first) / (4 * h);
      EXPECT_NEAR(jacobian->gradient[k], slope, 1e-3 * (1 + std::abs(slope))) << k;
      EXPECT_GE(jacobian->matrix[k * knots.size() + k], 0);
    }
  }
}

}  // namespace
}  // namespace knotfit::correction
