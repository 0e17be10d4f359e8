#include "knotfit/openings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "clouds.h"
#include "knotfit/exceptions.h"
#include "knotfit/parameterize_cloud.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using std::numbers::pi;

/// Around the z axis, with noise in the radius.
Points tube(Random& random, int count, double noise, double turn = 2 * pi) {
  Points p;
  for (int k = 0; k < count; ++k) {
    const double a = turn * random.unit(), r = 1 + noise * (2 * random.unit() - 1);
    p.insert(p.end(), {r * std::cos(a), r * std::sin(a), 3 * random.unit()});
  }
  return p;
}

double total(const std::vector<Opening>& openings) {
  double sum = 0;
  for (const Opening& o : openings) sum += o.share_of_square;
  return sum;
}

TEST(Openings, AreTheJoinedPartsOfTheVirtualFaces) {
  // 6 x 6 cells of two triangles; the middle 2 x 2 and one in the corner are virtual.
  Mesh mesh;
  std::vector<double> uv;
  for (int j = 0; j <= 6; ++j)
    for (int i = 0; i <= 6; ++i) {
      mesh.vertices.insert(mesh.vertices.end(), {10.0 + i, 20.0 + 2 * j, 5});
      uv.insert(uv.end(), {i / 6.0, j / 6.0});
    }
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) {
      const std::int32_t k = 7 * j + i;
      const bool closing = (i / 2 == 1 && j / 2 == 1) || (i == 5 && j == 0);
      mesh.faces.push_back({k, k + 1, k + 8});
      mesh.faces.push_back({k, k + 8, k + 7});
      mesh.virtual_face.insert(mesh.virtual_face.end(), 2, closing);
    }
  std::vector<Opening> openings = find_openings(mesh);
  ASSERT_EQ(openings.size(), 2u);
  EXPECT_EQ(openings[0].faces.size(), 8u);
  EXPECT_NEAR(openings[0].length, 2 * (2 + 4), 1e-12);
  EXPECT_NEAR(openings[0].place[0], 13, 1e-12);
  EXPECT_NEAR(openings[0].place[1], 26, 1e-12);
  EXPECT_NEAR(openings[0].place[2], 5, 1e-12);
  EXPECT_NEAR(openings[1].length, 2 * (1 + 2), 1e-12);
  measure_openings(openings, mesh, uv);
  EXPECT_NEAR(openings[0].share_of_square, 4 / 36.0, 1e-12);
  EXPECT_NEAR(openings[1].share_of_square, 1 / 36.0, 1e-12);
  EXPECT_NEAR(covered_share(mesh, uv, openings), 31 / 36.0, 1e-12);
  EXPECT_EQ(covered_share(mesh, uv, {}), 1);
  EXPECT_EQ(describe(openings),
            "2 openings beside the rim, at (13, 26, 5) 12 around, at (15.5, 21, 5) 6 around");
  mesh.virtual_face.clear();
  EXPECT_TRUE(find_openings(mesh).empty());
  mesh.faces[0][0] = 99;
  expect_throw<InvalidInput>([&] { find_openings(mesh); }, "corner 99");
}

TEST(CloudOpenings, ThreeWindowsOfAPlateAreFoundWhereTheyAre) {
  const std::vector<Window> windows{{0.5, 0.75, 0.14}, {0.25, 0.25, 0.12}, {0.7, 0.3, 0.1}};
  Random random;
  for (int round = 0; round < 5; ++round) {
    const Points p = sheet_with_windows(random, 2500, windows);
    expect_throw<InvalidInput>([&] { parameterize_cloud(p); }, "3 openings beside the rim, at (");
    expect_throw<InvalidInput>([&] { parameterize_cloud(p); }, "`fill_holes`");
    expect_throw<InvalidInput>([&] { parameterize_cloud(p); }, "`height_field`");
    for (const CloudBase base : {CloudBase::plane, CloudBase::graph}) {
      const CloudMap c = parameterize_cloud(p, {.base = base, .map = {.newton = false}, .fill_holes = true});
      ASSERT_EQ(c.openings.size(), 3u);
      double area = 0;
      for (const Window& w : windows) {
        // A rim of points 1/45 apart at random, of which a side may lie farther out: their order by length is chance.
        const auto near =
            std::min_element(c.openings.begin(), c.openings.end(), [&](const Opening& x, const Opening& y) {
              return std::hypot(x.place[0] - w.x, x.place[1] - w.y) <
                     std::hypot(y.place[0] - w.x, y.place[1] - w.y);
            });
        EXPECT_LT(std::hypot(near->place[0] - w.x, near->place[1] - w.y), 0.07);
        EXPECT_GT(near->length, 2 * pi * w.radius);
        EXPECT_LT(near->length, 1.8 * 2 * pi * w.radius);
        area += pi * w.radius * w.radius;
      }
      if (base == CloudBase::plane) {
        EXPECT_GT(total(c.openings), area);
        EXPECT_LT(total(c.openings), 1.4 * area);
      }
      EXPECT_NEAR(c.covered, c.outlined - total(c.openings), 1e-9);
      EXPECT_NE(describe(c).find("3 openings closed by triangles that are no data"), std::string::npos);
    }
  }
}

TEST(CloudOpenings, ATubeIsRefusedWithTheCylinderItIs) {
  Random random;
  for (const double noise : {0.0, 0.01})
    for (const int count : {1000, 3000}) {
      const Points p = tube(random, count, noise);
      expect_throw<InvalidInput>([&] { parameterize_cloud(p); }, "1 opening beside the rim, at (");
      expect_throw<InvalidInput>([&] { parameterize_cloud(p); }, "`base = cylinder`");
      expect_throw<InvalidInput>([&] { parameterize_cloud(p); }, "`fill_holes`");
      EXPECT_TRUE(parameterize_cloud(p, {.base = CloudBase::cylinder}).openings.empty());
      const CloudMap filled = parameterize_cloud(p, {.map = {.newton = false}, .fill_holes = true});
      ASSERT_EQ(filled.openings.size(), 1u);
      EXPECT_GT(filled.openings[0].share_of_square, 0);
      EXPECT_LT(filled.covered, 1);
    }
}

TEST(CloudOpenings, SheetsWithoutOneHaveNone) {
  Random random;
  std::vector<Points> sheets;
  for (const int count : {100, 400, 3000, 20000}) sheets.push_back(sheet_with_windows(random, count, {}));
  for (const double growth : {20.0, 400.0}) {  // of the density across the sheet
    Points p;
    for (int k = 0; k < 4000; ++k) {
      const double x = std::log(1 + random.unit() * (growth - 1)) / std::log(growth), y = random.unit();
      p.insert(p.end(), {x, y, 0.1 * std::sin(3 * x)});
    }
    sheets.push_back(p);
  }
  for (const double jump : {16.0, 64.0}) {  // of the density in the middle of the sheet
    Points p;
    for (int k = 0; k < 4000; ++k) {
      const double x = 0.5 * random.unit() + (random.unit() < 1 / (1 + jump) ? 0.5 : 0), y = random.unit();
      p.insert(p.end(), {x, y, 0.1 * std::sin(3 * x)});
    }
    sheets.push_back(p);
  }
  Points lines;  // 10 times as dense along them as across
  for (int i = 0; i < 300; ++i)
    for (int j = 0; j < 30; ++j) lines.insert(lines.end(), {i / 299.0, j / 29.0, 0.1 * std::sin(i / 99.0)});
  Points thinned;  // a grid of which three in ten are left
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j)
      if (random.unit() < 0.3) thinned.insert(thinned.end(), {i / 99.0, j / 99.0, 0.1 * std::sin(i / 33.0)});
  sheets.push_back(thinned);
  for (const Points& p : sheets) {
    const CloudMap c = parameterize_cloud(p, {.map = {.newton = false}});
    EXPECT_TRUE(c.openings.empty()) << p.size() / 3 << ": " << describe(c.openings);
    EXPECT_LT(c.bare, 0.05) << p.size() / 3;
  }
  const CloudMap of_lines = parameterize_cloud(lines, {.base = CloudBase::plane});
  EXPECT_TRUE(of_lines.openings.empty());
}

TEST(CloudOpenings, ABayOfTheOutlineAndAThinSlitAreNone) {
  Random random;
  Points bay, slit;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j) {
      const double x = (i + 0.5 + 0.05 * random.unit()) / 60 - 0.5,
                   y = (j + 0.5 + 0.05 * random.unit()) / 60 - 0.5;
      const double r = std::hypot(x, y), z = 0.1 * std::sin(3 * x);
      if (r > 0.2 && r < 0.5 && std::abs(std::atan2(y, x)) > 0.3) bay.insert(bay.end(), {x, y, z});
      if (std::abs(x) > 0.6 / 60 || std::abs(y) > 0.3) slit.insert(slit.end(), {x, y, z});
    }
  const CloudMap c = parameterize_cloud(bay, {.map = {.newton = false}});
  EXPECT_TRUE(c.mapped);
  EXPECT_TRUE(c.openings.empty());
  EXPECT_EQ(c.covered, 1);
  EXPECT_TRUE(parameterize_cloud(slit, {.map = {.newton = false}}).openings.empty());
}

TEST(CloudOpenings, ASquareThatIsBareInItsCornersIsRefusedOverAPlane) {
  Random random;
  Points p;
  while (p.size() < 3 * 1500) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    if (std::hypot(x, y) < 1) p.insert(p.end(), {x, y, 0.2 * x * x});
  }
  expect_throw<InvalidInput>([&] { parameterize_cloud(p, {.base = CloudBase::plane}); },
                             "of the square would be without data");
  expect_throw<InvalidInput>([&] { parameterize_cloud(p, {.base = CloudBase::plane}); }, "`base = graph`");
  const CloudMap c = parameterize_cloud(p, {.base = CloudBase::plane, .fill_holes = true});
  EXPECT_GT(c.bare, 0.05);
  EXPECT_LT(c.bare, 1 - pi / 4);
  EXPECT_TRUE(c.openings.empty());
}

TEST(CloudOpenings, GivenParametersAreLeftAsTheyAre) {
  Random random;
  const Points p = sheet_with_windows(random, 2000, {{0.5, 0.5, 0.25}});
  std::vector<double> uv;
  for (std::size_t k = 0; k < p.size(); k += 3) uv.insert(uv.end(), {p[k], p[k + 1]});
  const CloudMap c = triangulate_parameters(p, uv);
  for (std::size_t k = 0; k < uv.size(); ++k) EXPECT_NEAR(c.map.uv[k], uv[k], 1e-7);
  EXPECT_LE(c.openings.size(), 1u);
}

}  // namespace
}  // namespace knotfit::test
