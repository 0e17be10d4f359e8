#include "knotfit/base_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using Curve = std::vector<double>;

/// A quarter of a wavy sheet's border: x over [0, 4], y over [0, 3].
double height(double x, double y) {
  return 0.3 * std::sin(x) * std::cos(y);
}
Curve side(double x0, double y0, double x1, double y1) {
  Curve c;
  for (int k = 0; k <= 40; ++k) {
    const double x = x0 + (x1 - x0) * k / 40, y = y0 + (y1 - y0) * k / 40;
    c.insert(c.end(), {x, y, height(x, y)});
  }
  return c;
}
std::array<Curve, 4> border() {
  return {side(0, 0, 4, 0), side(4, 0, 4, 3), side(4, 3, 0, 3), side(0, 3, 0, 0)};
}

TEST(CoonsSurface, HasTheFourCurvesAsItsSides) {
  const Surface s = coons_surface(border());
  for (int k = 0; k <= 20; ++k) {
    const double t = k / 20.0;
    const double places[4][2] = {{t, 0}, {1, t}, {t, 1}, {0, t}};
    for (const auto& [u, v] : places) {
      double p[3];
      evaluate(s, u, v, p);
      EXPECT_NEAR(p[2], height(p[0], p[1]), 2e-3);  // chords of the curves and least squares
      EXPECT_NEAR(p[0], 4 * u, 0.1);                // by chord length
      EXPECT_NEAR(p[1], 3 * v, 0.1);
    }
  }
}

TEST(CoonsSurface, TakesCurvesInAnyOrderAndDirection) {
  const auto given = border();
  const auto turned = [](Curve c) {
    Curve out;
    for (std::size_t k = c.size(); k > 0; k -= 3) out.insert(out.end(), {c[k - 3], c[k - 2], c[k - 1]});
    return out;
  };
  const Surface s = coons_surface(given),
                t = coons_surface({given[0], given[2], turned(given[1]), turned(given[3])});
  for (std::size_t k = 0; k < s.net().size(); ++k) EXPECT_NEAR(s.net()[k], t.net()[k], 1e-9);
}

TEST(CoonsSurface, SaysWhatKeepsTheCurvesFromALoop) {
  auto curves = border();
  curves[2] = side(4, 3, 0.5, 3);
  expect_throw<InvalidInput>([&] { coons_surface(curves); }, "no closed loop");
  curves = border();
  curves[1] = {1, 2, 3};
  expect_throw<InvalidInput>([&] { coons_surface(curves); }, "boundary curve 2 has 1 points");
  curves[1] = {1, 2, 3, 1, 2, 3};
  expect_throw<InvalidInput>([&] { coons_surface(curves); }, "boundary curve 2 has no length");
  curves[1][4] = NAN;
  expect_throw<InvalidInput>([&] { coons_surface(curves); }, "coordinate of point 2 is not finite");
}

TEST(CloudOverASurface, HasItsParameters) {
  Random random;
  const Surface base = coons_surface(border());
  std::vector<double> points, at;
  // The corners, so that the square is filled, and a cloud 0.01 off the surface.
  for (int k = 0; k < 1500; ++k) {
    const double u = k < 4 ? k % 2 : random.unit(), v = k < 4 ? k / 2 : random.unit();
    const LocalGeometry g = local_geometry(base, u, v);
    const double off = k < 4 ? 0 : random.uniform(-0.01, 0.01);
    at.insert(at.end(), {u, v});
    for (int d = 0; d < 3; ++d) points.push_back(g.point[d] + off * g.normal[d]);
  }
  const CloudMap c = parameterize_cloud(points, base);
  EXPECT_EQ(c.base, CloudBase::surface);
  EXPECT_NEAR(c.scatter, 0.01 / std::sqrt(3), 1e-3);
  EXPECT_EQ(c.map.quality.flipped, 0);
  for (std::size_t k = 0; k < at.size(); ++k) EXPECT_NEAR(c.map.uv[k], at[k], 1e-6);
}

TEST(CloudOverASurface, GoesOnBeyondItsSides) {
  // A flat base over [0,4] x [0,3]; points over [-1,5] x [-1,4].
  const auto flat = [](double x0, double y0, double x1, double y1) {
    return Curve{x0, y0, 0, (x0 + x1) / 2, (y0 + y1) / 2, 0, x1, y1, 0};
  };
  const Surface base =
      coons_surface({flat(0, 0, 4, 0), flat(4, 0, 4, 3), flat(4, 3, 0, 3), flat(0, 3, 0, 0)});
  std::vector<double> points;
  for (int i = 0; i <= 24; ++i)
    for (int j = 0; j <= 20; ++j) points.insert(points.end(), {-1 + 0.25 * i, -1 + 0.25 * j, 0.1});
  const CloudMap c = parameterize_cloud(points, base);
  EXPECT_EQ(c.coincident + c.lone, 0);
  for (Index k = 0; k < c.points; ++k) {
    EXPECT_NEAR(c.map.uv[2 * k], (points[3 * k] + 1) / 6, 1e-6);
    EXPECT_NEAR(c.map.uv[2 * k + 1], (points[3 * k + 1] + 1) / 5, 1e-6);
  }
}

}  // namespace
}  // namespace knotfit::test
