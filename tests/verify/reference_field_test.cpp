#include "verify/reference_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/random_splines.h"
#include "support/two_threads.h"
namespace knotfit::verify {
namespace {

using namespace knotfit::test;

/// Random places in the square with heights of a plane, and noise.
ParameterizedPoints plane(int n, double noise) {
  Random random(3);
  ParameterizedPoints points;
  for (int k = 0; k < n; ++k) {
    const double u = random.unit(), v = random.unit();
    points.uv.insert(points.uv.end(), {u, v});
    points.values.push_back(2 * u - 3 * v + noise * (random.unit() + random.unit() + random.unit() - 1.5));
  }
  return points;
}

std::vector<Place> places() {
  std::vector<Place> all;
  for (int i = 1; i < 10; ++i)
    for (int j = 1; j < 10; ++j) all.push_back({i / 10.0, j / 10.0});
  return all;
}

TEST(ReferenceField, KnowsAPlaneBetweenItsPoints) {
  const ReferenceField field(plane(800, 0), 0.01, {}, {}, 1);
  EXPECT_EQ(field.noise(), 0);
  const std::vector<Place> where = places();
  const std::vector<ReferenceValue> values = field.at(where);
  ASSERT_EQ(values.size(), where.size());
  for (std::size_t k = 0; k < where.size(); ++k)
    EXPECT_NEAR(values[k].value[0], 2 * where[k][0] - 3 * where[k][1], 1e-6) << k;
}

TEST(ReferenceField, FindsTheNoiseThatIsThere) {
  // Three numbers of [0,1) have a standard deviation of 1/2.
  const ReferenceField noisy(plane(3000, 0.1), 0.1, {}, {}, 1);
  EXPECT_NEAR(noisy.noise(), 0.05, 0.02);
  EXPECT_EQ(ReferenceField(plane(3000, 0.1), 100, {}, {}, 1).noise(), 0) << "below 0.02 of the tolerance";
}

TEST(ReferenceField, StopsWhereAskedAndIsTheSameForAnyNumberOfThreads) {
  const ReferenceField field(plane(500, 0), 0.01, {}, {}, 1);
  EXPECT_TRUE(field.at(places(), [](Index) { return false; }).empty());
  const auto [one, two] = on_one_and_two_threads([&] { return field.at(places()); });
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one[k].value, two[k].value);
}

}  // namespace
}  // namespace knotfit::verify
