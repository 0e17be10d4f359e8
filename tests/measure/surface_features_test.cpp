// Feature measures of surfaces whose derivatives and curvatures are known.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/features.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

/// c0 + c1 u + c2 v + c3 u^2 + c4 u v + c5 v^2 exactly, as a biquadratic Bezier patch (blossom at
/// the corners 0, 0; 0, 1; 1, 1), each component its own c.
Surface quadratic(const std::vector<std::array<double, 6>>& c) {
  const int d = static_cast<int>(c.size());
  std::vector<double> net;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int e = 0; e < d; ++e) {
        const double u = i / 2.0, v = j / 2.0, uu = i == 2, vv = j == 2;
        const auto& k = c[static_cast<std::size_t>(e)];
        net.push_back(k[0] + k[1] * u + k[2] * v + k[3] * uu + k[4] * u * v + k[5] * vv);
      }
  return Surface(KnotVector::uniform(2, 0), KnotVector::uniform(2, 0), d, net);
}

void expect_everywhere(const FeatureMap& map, const std::function<double(double, double)>& f,
                       double tolerance) {
  validate(map);
  for (Index i = 0; i < map.size_u; ++i)
    for (Index j = 0; j < map.size_v; ++j) {
      const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(map.size_u);
      const double v = (static_cast<double>(j) + 0.5) / static_cast<double>(map.size_v);
      EXPECT_NEAR(map.f[i * map.size_v + j], f(u, v), tolerance) << u << ", " << v;
    }
}

TEST(HessianFeatures, OfAQuadraticAreItsHessian) {
  // z_uu = 6, z_uv = 2, z_vv = -4.
  const FeatureMap map = hessian_features(quadratic({{1, 2, 3, 3, 2, -2}}), 17);
  EXPECT_EQ(map.size_u, 17);
  EXPECT_EQ(map.size_v, 17);
  const double expected = std::pow(36 + 2 * 4 + 16, 0.25);
  expect_everywhere(
      map, [&](double, double) { return expected; }, 100 * kEps * expected);
}

TEST(HessianFeatures, AddTheComponents) {
  const FeatureMap map =
      hessian_features(quadratic({{0, 1, 0, 3, 0, 0}, {0, 0, 1, 0, 2, 0}, {0, 0, 0, 0, 0, 1}}), 5);
  const double expected = std::pow(36 + 2 * 4 + 4, 0.25);
  expect_everywhere(
      map, [&](double, double) { return expected; }, 100 * kEps * expected);
}

TEST(HessianFeatures, AreThoseOfTheDerivativesAtTheCellCentres) {
  Random random;
  const KnotVector u = KnotVector::uniform(4, 3), v = KnotVector::uniform(3, 2);
  const Surface s(u, v, 2, random_numbers(random, u.size() * v.size() * 2));
  const FeatureMap map = hessian_features(s, 13);
  expect_everywhere(
      map,
      [&](double a, double b) {
        const std::vector<double> d = evaluate_derivatives(s, a, b, 2);
        double sum = 0;
        for (std::size_t e = 0; e < 2; ++e) {
          auto at = [&](std::size_t i, std::size_t j) { return d[(i * 3 + j) * 2 + e]; };
          sum += at(2, 0) * at(2, 0) + 2 * at(1, 1) * at(1, 1) + at(0, 2) * at(0, 2);
        }
        return std::pow(sum, 0.25);
      },
      1e-11);
}

TEST(HessianFeatures, OfAPlaneAreZero) {
  expect_everywhere(
      hessian_features(quadratic({{1, 2, 3, 0, 0, 0}}), 7), [](double, double) { return 0; }, 1e-6);
}

TEST(CurvatureFeatures, OfAParabolicCylinderAreItsCurvature) {
  // (u, v, u^2): k1 = 2 / (1 + 4 u^2)^{3/2}, k2 = 0, |S_u x S_v| = (1 + 4 u^2)^{1/2}.
  const auto expected = [](double u, double) {
    const double g = 1 + 4 * u * u;
    return std::sqrt(2 / std::pow(g, 1.5)) * std::sqrt(g);
  };
  const Surface height = quadratic({{0, 0, 0, 1, 0, 0}});
  const Surface space = quadratic({{0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 1, 0, 0}});
  expect_everywhere(curvature_features(height, 20), expected, 1e-13);
  expect_everywhere(curvature_features(space, 20), expected, 1e-13);
}

TEST(CurvatureFeatures, OfASaddleAreThoseOfBothPrincipalCurvatures) {
  // z = u v: EG - F^2 = 1 + u^2 + v^2 = g, H = -u v / g^{3/2}, K = -1 / g^2.
  expect_everywhere(
      curvature_features(quadratic({{0, 0, 0, 0, 1, 0}}), 20),
      [](double u, double v) {
        const double g = 1 + u * u + v * v, h = -u * v / std::pow(g, 1.5), k = -1 / (g * g);
        return std::pow(4 * h * h - 2 * k, 0.25) * std::sqrt(g);
      },
      1e-13);
}

TEST(CurvatureFeatures, AgreeWithTheLocalGeometry) {
  Random random;
  const KnotVector u = KnotVector::uniform(3, 3), v = KnotVector::uniform(4, 2);
  const Surface s(u, v, 3, random_numbers(random, u.size() * v.size() * 3));
  expect_everywhere(
      curvature_features(s, 15),
      [&](double a, double b) {
        const LocalGeometry g = local_geometry(s, a, b);
        return std::pow(g.k1 * g.k1 + g.k2 * g.k2, 0.25) * g.area_element;
      },
      1e-7);
}

TEST(CurvatureFeatures, OfTheSphereAreOneOverItsRadius) {
  // A cap z = sqrt(R^2 - x^2 - y^2): k1 = k2 = 1/R, area element R / z.
  const double radius = 3;
  std::vector<double> net;
  // Cubic quasi-interpolant on uniform knots: c = f - h^2/6 f'', good to O(h^4) [deBoor01 XII].
  const KnotVector cubic = KnotVector::uniform(3, 59);
  const std::vector<double> greville = cubic.greville();
  const double h = 1 / 60.0;
  auto f = [&](double x, double y) { return std::sqrt(radius * radius - x * x - y * y); };
  for (double x : greville)
    for (double y : greville) {
      const double e = 1e-3;
      const double laplace = (f(x + e, y) + f(x - e, y) + f(x, y + e) + f(x, y - e) - 4 * f(x, y)) / (e * e);
      net.push_back(f(x, y) - h * h / 6 * laplace);
    }
  const FeatureMap map = curvature_features(Surface(cubic, cubic, 1, net), 40);
  for (Index i = 4; i < 36; ++i)  // away from the border, where the knots are not uniform
    for (Index j = 4; j < 36; ++j) {
      const double x = (static_cast<double>(i) + 0.5) / 40, y = (static_cast<double>(j) + 0.5) / 40;
      const double expected = std::pow(2 / (radius * radius), 0.25) * radius / f(x, y);
      EXPECT_NEAR(map.f[i * 40 + j], expected, 1e-3 * expected);
    }
}

TEST(CurvatureFeatures, AreZeroWhereThereIsNoNormal) {
  // All on a line: S_u x S_v = 0.
  const Surface line = quadratic({{0, 1, 1, 1, 0, 0}, {0, 2, 2, 2, 0, 0}, {0, 0, 0, 0, 0, 0}});
  for (double f : curvature_features(line, 6).f) EXPECT_EQ(f, 0);
}

TEST(CurvatureFeatures, NeedAHeightFieldOrASurfaceInSpace) {
  expect_throw<InvalidInput>(
      [] {
        curvature_features(quadratic({{}, {}}), 5);
      },
      "curvature needs a height field or a surface in R^3, not dimension 2");
}

TEST(Features, NeedACell) {
  const Surface s = quadratic({{}});
  expect_throw<InvalidInput>([&] { hessian_features(s, 0); }, "at least one cell");
  expect_throw<InvalidInput>([&] { curvature_features(s, -1); }, "at least one cell");
}

}  // namespace
}  // namespace knotfit::test
