#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
namespace knotfit {
namespace {

using test::expect_throw;

PointTable table_of(Index n, bool with_xy = true) {
  PointTable table;
  test::Uniform random(6);
  for (Index k = 0; k < n; ++k) {
    if (with_xy) table.x.push_back(random()), table.y.push_back(random());
    table.z.push_back(random());
    table.u.push_back(0.1 + 0.8 * random()), table.v.push_back(0.2 + 0.5 * random());
    table.line.push_back(k + 2);
  }
  return table;
}

TEST(GivenParameters, AreTakenAsTheyAre) {
  PointTable table = table_of(100);
  table.u[0] = 0, table.v[1] = 1;  // the ends belong to it
  table.weight.assign(100, 3);
  const ParameterizedPoints points = parameterize_given(table);
  validate(points);
  EXPECT_EQ(points.dimension, 3);
  EXPECT_FALSE(points.height_field);
  EXPECT_TRUE(points.map.identity());
  EXPECT_EQ(points.source, table.line);
  EXPECT_EQ(points.weights, table.weight);
  for (Index k = 0; k < 100; ++k) {
    EXPECT_EQ(points.u(k), table.u[k]);
    EXPECT_EQ(points.v(k), table.v[k]);
    EXPECT_EQ(points.value(k)[0], table.x[k]);
    EXPECT_EQ(points.value(k)[1], table.y[k]);
    EXPECT_EQ(points.value(k)[2], table.z[k]);
  }
}

TEST(GivenParameters, WithZAloneAreOfOneComponent) {
  const PointTable table = table_of(100, false);
  const ParameterizedPoints points = parameterize_given(table);
  EXPECT_EQ(points.dimension, 1);
  EXPECT_FALSE(points.height_field);
  EXPECT_EQ(points.values, table.z);
}

TEST(GivenParameters, AreRescaledOnRequestAndTheMapIsKept) {
  PointTable table = table_of(100);
  for (double& u : table.u) u = 5e6 + 300 * u;
  const ParameterizedPoints points = parameterize_given(table, true);
  double low = 1, high = 0;
  for (Index k = 0; k < 100; ++k) {
    low = std::min(low, points.v(k)), high = std::max(high, points.v(k));
    EXPECT_NEAR(points.map.from_u(points.u(k)), table.u[k], 1e-9);
    EXPECT_NEAR(points.map.from_v(points.v(k)), table.v[k], 1e-15);
  }
  EXPECT_EQ(low, 0);
  EXPECT_EQ(high, 1);
  EXPECT_EQ(points.map.name_u, "u");
  EXPECT_FALSE(points.map.identity());
}

TEST(GivenParameters, OutsideTheSquareNameTheirLinesAndTheOption) {
  PointTable table = table_of(100);
  table.u[12] = 1.2;
  expect_throw<InvalidInput>([&] { parameterize_given(table); },
                             "line 14: u = 1.2 is outside [0,1]; `rescale`");
  table.v[44] = -0.05;
  expect_throw<InvalidInput>([&] { parameterize_given(table); },
                             "line 14: u = 1.2 is outside [0,1], likewise line 46;");
  table.u[12] = 0.5;
  expect_throw<InvalidInput>([&] { parameterize_given(table); }, "line 46: v = -0.05 is outside [0,1]");
  for (Index k = 50; k < 90; ++k) table.u[k] = 7;
  expect_throw<InvalidInput>([&] { parameterize_given(table); },
                             "likewise lines 52, 53, 54, 55, 56, 57, 58, 59 and 32 more");
  table.line.clear();
  expect_throw<InvalidInput>([&] { parameterize_given(table); }, "point 45: v = -0.05");
}

TEST(GivenParameters, AreAskedForByTheOptionThatHelps) {
  PointTable table = table_of(10);
  table.u.clear(), table.v.clear();
  expect_throw<InvalidInput>([&] { parameterize_given(table); }, "`height_field` fits z over (x, y)");
  table.x.clear(), table.y.clear();
  expect_throw<InvalidInput>([&] { parameterize_given(table); }, "no u, v columns");
}

TEST(GivenParameters, MustSpanThePlane) {
  PointTable table = table_of(10);
  std::fill(table.u.begin(), table.u.end(), 0.5);
  for (bool rescale : {false, true})
    expect_throw<InvalidInput>([&] { parameterize_given(table, rescale); },
                               "all 10 points have u = 0.5: they lie on one straight line in (u, v)");
  table = table_of(10);
  table.v = table.u;
  expect_throw<InvalidInput>([&] { parameterize_given(table); }, "one straight line in (u, v)");
}

TEST(GivenParameters, NameTheLineOfWhatIsNoNumber) {
  PointTable table = table_of(10);
  table.v[3] = std::nan("");
  expect_throw<InvalidInput>([&] { parameterize_given(table, true); }, "line 5: v = nan");
  table = table_of(10);
  table.v.pop_back();
  expect_throw<InvalidInput>([&] { parameterize_given(table); }, "column v has 9 values");
}

}  // namespace
}  // namespace knotfit
