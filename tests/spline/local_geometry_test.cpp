#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

/// The biquadratic patch over [-1,1]^2 with x = f(u,v) exactly, for f of degree 2 in u and v: its
/// Bezier points from the values at -1, 0, 1: c_1 = 2 f(0) - (f(-1) + f(1)) / 2.
Surface quadratic_patch(const std::function<std::array<double, 3>(double, double)>& f) {
  const KnotVector t = KnotVector::clamped(2, {}, -1, 1);
  const double to_bezier[3][3] = {{1, 0, 0}, {-0.5, 2, -0.5}, {0, 0, 1}};
  std::vector<double> net(27, 0.0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          for (int d = 0; d < 3; ++d)
            net[static_cast<std::size_t>((i * 3 + j) * 3 + d)] +=
                to_bezier[i][a] * to_bezier[j][b] * f(a - 1, b - 1)[static_cast<std::size_t>(d)];
  return Surface(t, t, 3, net);
}

// Derivatives of order 2 of numbers of size 1: a few dozen roundings.
constexpr double kFew = 100 * kEps;

TEST(LocalGeometry, OfAParaboloidAtItsVertex) {
  for (const auto& [a, b] : {std::pair{1.0, 0.5}, {0.25, 2.0}, {1.0, -1.0}, {-3.0, -2.0}, {0.0, 0.0}}) {
    const Surface s = quadratic_patch([&](double u, double v) {
      return std::array{u, v, a * u * u + b * v * v};
    });
    const LocalGeometry g = local_geometry(s, 0, 0);
    const double size = kFew * (std::abs(a) + std::abs(b) + 1);
    EXPECT_NEAR(g.k1, 2 * std::max(a, b), size);
    EXPECT_NEAR(g.k2, 2 * std::min(a, b), size);
    EXPECT_NEAR(g.mean_curvature, a + b, size);
    EXPECT_NEAR(g.gaussian_curvature, 4 * a * b, size * (std::abs(a) + std::abs(b) + 1) * 4);
    EXPECT_NEAR(g.normal[0], 0, kFew);
    EXPECT_NEAR(g.normal[1], 0, kFew);
    EXPECT_NEAR(g.normal[2], 1, kFew);
    EXPECT_NEAR(g.area_element, 1, kFew);
    EXPECT_FALSE(g.degenerate);
  }
}

// Away from the vertex, z = a x^2 + b y^2 has H and K of a graph [doCarmo76 3.3, example 5].
TEST(LocalGeometry, OfAGraphIsThatOfTheTextbook) {
  Random random;
  for (int k = 0; k < 200; ++k) {
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1), c = random.uniform(-1, 1);
    const Surface s = quadratic_patch([&](double u, double v) {
      return std::array{u, v, a * u * u + b * v * v + c * u * v};
    });
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const double zx = 2 * a * x + c * y, zy = 2 * b * y + c * x, zxx = 2 * a, zyy = 2 * b, zxy = c;
    const double w = 1 + zx * zx + zy * zy;
    const LocalGeometry g = local_geometry(s, x, y);
    EXPECT_NEAR(g.gaussian_curvature, (zxx * zyy - zxy * zxy) / (w * w), 10 * kFew);
    EXPECT_NEAR(g.mean_curvature,
                ((1 + zx * zx) * zyy - 2 * zx * zy * zxy + (1 + zy * zy) * zxx) / (2 * std::pow(w, 1.5)),
                10 * kFew);
    EXPECT_NEAR(g.area_element, std::sqrt(w), kFew);
    EXPECT_NEAR(g.k1 * g.k2, g.gaussian_curvature, 10 * kFew);
    EXPECT_NEAR(g.k1 + g.k2, 2 * g.mean_curvature, kFew);
    EXPECT_GE(g.k1, g.k2);
    const double normal[3] = {-zx / std::sqrt(w), -zy / std::sqrt(w), 1 / std::sqrt(w)};
    for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(g.normal[d], normal[d], kFew);
  }
}

TEST(LocalGeometry, DoesNotDependOnTheParameterization) {
  // The same paraboloid through a sheared, stretched map of the parameters.
  const Surface plain = quadratic_patch([](double u, double v) {
    return std::array{u, v, u * u + 0.5 * v * v};
  });
  const Surface sheared = quadratic_patch([](double u, double v) {
    const double x = 0.01 * u + 0.3 * v, y = 0.4 * v;
    return std::array{x, y, x * x + 0.5 * y * y};
  });
  for (double u : {-0.9, 0.0, 0.4})
    for (double v : {-0.6, 0.3, 1.0}) {
      const LocalGeometry a = local_geometry(plain, 0.01 * u + 0.3 * v, 0.4 * v),
                          b = local_geometry(sheared, u, v);
      // The angle between S_u and S_v and the short S_u (1/100) magnify the rounding of S_uu by 1e4.
      EXPECT_NEAR(a.k1, b.k1, 1e5 * kFew);
      EXPECT_NEAR(a.k2, b.k2, 1e5 * kFew);
      EXPECT_NEAR(a.mean_curvature, b.mean_curvature, 1e5 * kFew);
    }
}

TEST(LocalGeometry, TurnsItsSignWithTheNormal) {
  const Surface s = quadratic_patch([](double u, double v) {
    return std::array{u, v, u * u + 0.25 * v * v};
  });
  const LocalGeometry up = local_geometry(s, 0.3, 0.2), down = local_geometry(transposed(s), 0.2, 0.3);
  EXPECT_NEAR(down.mean_curvature, -up.mean_curvature, kFew);
  EXPECT_NEAR(down.gaussian_curvature, up.gaussian_curvature, kFew);
  EXPECT_NEAR(down.k1, -up.k2, kFew);
  EXPECT_NEAR(down.normal[2], -up.normal[2], kFew);
}

TEST(LocalGeometry, OfACylinderAndASphere) {
  // cos and sin as their Taylor polynomials over a short arc.
  const int p = 9;
  const double width = 0.2;  // |x|^10 / 10! < 3e-14
  const KnotVector t = KnotVector::clamped(p, {}, -width, width);
  // Bezier points of a polynomial sum a_k x^k: blossom at j copies of +width, p - j of -width.
  const auto bezier = [&](const std::vector<double>& a) {
    std::vector<double> points;
    for (int j = 0; j <= p; ++j) {
      std::vector<double> e(static_cast<std::size_t>(p) + 1, 0.0);  // elementary symmetric functions
      e[0] = 1;
      for (int l = 0; l < p; ++l)
        for (int k = l + 1; k >= 1; --k) e[k] += e[k - 1] * (l < j ? width : -width);
      double sum = 0, binomial = 1;
      for (int k = 0; k <= p; ++k) {
        sum += a[k] * e[k] / binomial;
        binomial = binomial * (p - k) / (k + 1);
      }
      points.push_back(sum);
    }
    return points;
  };
  std::vector<double> cosine(10, 0.0), sine(10, 0.0), line(10, 0.0), one(10, 0.0);
  double factorial = 1;
  for (int k = 0; k <= 9; ++k) {
    if (k > 0) factorial *= k;
    (k % 2 == 0 ? cosine : sine)[k] = (k % 4 < 2 ? 1 : -1) / factorial;
  }
  line[1] = one[0] = 1;
  const std::vector<double> c = bezier(cosine), s = bezier(sine), l = bezier(line), o = bezier(one);
  const double radius = 2;
  std::vector<double> cylinder, sphere;
  for (std::size_t i = 0; i <= 9; ++i)
    for (std::size_t j = 0; j <= 9; ++j) {
      cylinder.insert(cylinder.end(), {radius * c[i] * o[j], radius * s[i] * o[j], l[j]});
      sphere.insert(sphere.end(), {radius * c[i] * c[j], radius * s[i] * c[j], radius * s[j]});
    }
  // Two derivatives of the Taylor remainder, |x|^8 / 8! < 7e-11, plus rounding of second
  // derivatives: p^2 / width^2 eps.
  const double close = 1e-10;
  for (double u : {-0.2, -0.1, 0.0, 0.15})
    for (double v : {-0.15, 0.0, 0.1, 0.2}) {
      const LocalGeometry g = local_geometry(Surface(t, t, 3, cylinder), u, v);
      EXPECT_NEAR(g.k1, 0, close);
      EXPECT_NEAR(g.k2, -1 / radius, close);  // the normal points outwards
      EXPECT_NEAR(g.gaussian_curvature, 0, close);
      EXPECT_NEAR(g.area_element, radius, close);
      EXPECT_NEAR(g.normal[0], std::cos(u), close);
      EXPECT_NEAR(g.normal[1], std::sin(u), close);
      const LocalGeometry b = local_geometry(Surface(t, t, 3, sphere), u, v);
      EXPECT_NEAR(b.k1, -1 / radius, close);
      EXPECT_NEAR(b.k2, -1 / radius, close);
      EXPECT_NEAR(b.gaussian_curvature, 1 / (radius * radius), close);
      EXPECT_NEAR(b.area_element, radius * radius * std::cos(v), 10 * close);
    }
}

TEST(LocalGeometry, HasNoNormalWhereTheSurfaceDegenerates) {
  const Surface collapsed = quadratic_patch([](double u, double) { return std::array{u, 2 * u, u * u}; });
  const LocalGeometry a = local_geometry(collapsed, 0.3, 0.1);
  EXPECT_TRUE(a.degenerate);
  EXPECT_EQ(a.normal, (std::array<double, 3>{}));
  EXPECT_NEAR(a.point[1], 0.6, kFew);
  const Surface folded = quadratic_patch([](double u, double v) {
    return std::array{u + v, 2 * (u + v), 0.0};
  });
  EXPECT_TRUE(local_geometry(folded, 0.3, 0.1).degenerate);
  const Surface tip = quadratic_patch([](double u, double v) { return std::array{(u + 1) * v, u + 1, 0.0}; });
  EXPECT_TRUE(local_geometry(tip, -1, 0.5).degenerate);
  EXPECT_FALSE(local_geometry(tip, 0, 0.5).degenerate);
}

TEST(LocalGeometry, DoesNotDependOnTheUnit) {
  Random random;
  for (double unit : {1e-100, 1e-9, 1e9, 1e100}) {
    const auto f = [](double u, double v) { return std::array{u, v, u * u + 0.5 * v * v + u * v}; };
    const LocalGeometry g = local_geometry(quadratic_patch(f), 0.2, 0.4);
    const LocalGeometry scaled = local_geometry(quadratic_patch([&](double u, double v) {
                                                  const auto x = f(u, v);
                                                  return std::array{unit * x[0], unit * x[1], unit * x[2]};
                                                }),
                                                0.2, 0.4);
    EXPECT_FALSE(scaled.degenerate);
    EXPECT_NEAR(scaled.k1 * unit, g.k1, kFew);
    EXPECT_NEAR(scaled.k2 * unit, g.k2, kFew);
  }
}

TEST(LocalGeometry, GivesNanForANanParameter) {
  const Surface s = quadratic_patch([](double u, double v) { return std::array{u, v, u * v}; });
  const LocalGeometry g = local_geometry(s, std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_TRUE(std::isnan(g.point[0]) && std::isnan(g.normal[2]) && std::isnan(g.k1) &&
              std::isnan(g.mean_curvature));
}

TEST(LocalGeometry, NamesWhatIsWrong) {
  const KnotVector t = KnotVector::uniform(1, 0);
  expect_throw<InvalidInput>(
      [&] { local_geometry(Surface(t, t, 1, std::vector<double>(4, 1.0)), 0, 0); },
      "need a surface in R^3, not R^1; a height field becomes one by height_field_in_space");
  expect_throw<InvalidInput>([&] { local_geometry(Surface(), 0, 0); }, "surface to evaluate is empty");
}

}  // namespace
}  // namespace knotfit::test
