#include "search/joined_points.h"

#include <gtest/gtest.h>

#include <limits>
namespace knotfit::test {
namespace {

ParameterizedPoints weighted() {
  ParameterizedPoints points;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      points.uv.insert(points.uv.end(), {i / 5.0, j / 5.0});
      points.values.push_back(i + j);
      points.weights.push_back(i < 3 ? 1 : 3);  // mean 2
    }
  return points;
}

TEST(JoinedPoints, BeginWithTheDataAndItsWeights) {
  const ParameterizedPoints data = weighted();
  const JoinedPoints joined(data);
  EXPECT_EQ(joined.data_count(), 36);
  EXPECT_EQ(joined.points().uv, data.uv);
  const MovingFit problem(joined.points(), 3, 3);
  const PointShares shares = joined.shares(problem);
  for (Index i = 0; i < 36; ++i) {
    EXPECT_EQ(shares.base[i], data.weights[problem.order().input(i)]);
    EXPECT_EQ(shares.inverse_slack[i], 1);
  }
}

TEST(JoinedPoints, TakeAPointInWithItsShareOfTheMeanWeightAndItsSlack) {
  JoinedPoints joined(weighted());
  const double value = 7;
  joined.join(0.25, 0.75, &value, 0.5, 2);
  joined.join(0.5, 0.5, &value, 1, std::numeric_limits<double>::infinity());
  EXPECT_EQ(joined.data_count(), 36);
  ASSERT_EQ(joined.points().size(), 38);
  EXPECT_EQ(joined.points().u(36), 0.25);
  EXPECT_EQ(joined.points().values[37], 7);
  EXPECT_EQ(joined.points().weights[36], 1);  // half of the mean of 2
  const MovingFit problem(joined.points(), 3, 3);
  const PointShares shares = joined.shares(problem);
  for (Index i = 0; i < 38; ++i) {
    const Index k = problem.order().input(i);
    EXPECT_EQ(shares.inverse_slack[i], k == 36 ? 0.5 : k == 37 ? 0 : 1);  // 0: not in the maximum
  }
}

}  // namespace
}  // namespace knotfit::test
