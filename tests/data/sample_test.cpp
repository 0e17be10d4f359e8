#include "data/sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>
namespace knotfit::test {
namespace {

ParameterizedPoints random_points(Index n, bool weighted) {
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  ParameterizedPoints points;
  for (Index k = 0; k < n; ++k) {
    const double u = uniform(engine), v = uniform(engine) * uniform(engine);  // denser at small v
    points.uv.insert(points.uv.end(), {u, v});
    points.values.push_back(std::sin(7 * u) * v);
    if (weighted) points.weights.push_back(0.5 + uniform(engine));
  }
  return points;
}

TEST(Sample, OfNoMorePointsThanAskedForIsThePointsThemselves) {
  const ParameterizedPoints points = random_points(50, true), same = stratified_sample(points, 50);
  EXPECT_EQ(same.uv, points.uv);
  EXPECT_EQ(same.values, points.values);
  EXPECT_EQ(same.weights, points.weights);
}

TEST(Sample, HoldsDifferentPointsOfTheDataAboutAsManyAsAskedFor) {
  const ParameterizedPoints points = random_points(40000, false), few = stratified_sample(points, 2000);
  EXPECT_GT(few.size(), 1600);
  EXPECT_LE(few.size(), 2100);
  std::set<std::array<double, 3>> all, drawn;
  for (Index k = 0; k < points.size(); ++k) all.insert({points.u(k), points.v(k), points.values[k]});
  for (Index k = 0; k < few.size(); ++k) drawn.insert({few.u(k), few.v(k), few.values[k]});
  EXPECT_EQ(static_cast<Index>(drawn.size()), few.size());
  for (const auto& p : drawn) EXPECT_TRUE(all.contains(p));
}

TEST(Sample, WeighsWhatEachPointStandsFor) {
  for (const bool weighted : {false, true}) {
    const ParameterizedPoints points = random_points(40000, weighted), few = stratified_sample(points, 2000);
    // The mean weight stays, and weighted means over the sample are those of the data.
    const auto mean = [](const ParameterizedPoints& p, auto&& of) {
      double sum = 0, weight = 0;
      for (Index k = 0; k < p.size(); ++k) sum += p.weight(k) * of(k), weight += p.weight(k);
      return std::array{sum / weight, weight / static_cast<double>(p.size())};
    };
    const auto v_all = mean(points, [&](Index k) { return points.v(k); });
    const auto v_few = mean(few, [&](Index k) { return few.v(k); });
    EXPECT_NEAR(v_few[0], v_all[0], 2e-3);
    EXPECT_NEAR(v_few[1], v_all[1], 1e-12);
  }
}

TEST(Sample, LeavesNoRegionUnseen) {
  // 30 000 points in one corner, 300 over all the rest.
  ParameterizedPoints points = random_points(300, false);
  const ParameterizedPoints corner = random_points(30000, false);
  for (Index k = 0; k < corner.size(); ++k) {
    points.uv.insert(points.uv.end(), {0.01 * corner.u(k), 0.01 * corner.v(k)});
    points.values.push_back(corner.values[k]);
  }
  const ParameterizedPoints few = stratified_sample(points, 1000);
  Index outside = 0;
  for (Index k = 0; k < few.size(); ++k) outside += few.u(k) > 0.05 || few.v(k) > 0.05;
  EXPECT_GT(outside, 200);
}

TEST(Sample, OfARasterFollowsNoRowOrColumn) {
  ParameterizedPoints points;
  for (int i = 0; i < 200; ++i)
    for (int j = 0; j < 200; ++j) {
      points.uv.insert(points.uv.end(), {i / 199.0, j / 199.0});
      points.values.push_back(0);
    }
  const ParameterizedPoints few = stratified_sample(points, 2000);
  std::set<double> rows, columns;
  for (Index k = 0; k < few.size(); ++k) rows.insert(few.u(k)), columns.insert(few.v(k));
  EXPECT_GT(rows.size(), 190u);
  EXPECT_GT(columns.size(), 190u);
}

}  // namespace
}  // namespace knotfit::test
