#include "parameterize/cloud_base.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::cloud {
namespace {

using namespace knotfit::test;

double distance(const double* a, const double* b, int dimension) {
  double sum = 0;
  for (int d = 0; d < dimension; ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
  return std::sqrt(sum);
}

TEST(ProjectToPlane, KeepsTheDistancesOfFlatPoints) {
  Random random;
  std::vector<double> points;
  for (int k = 0; k < 40; ++k) {  // on a plane that leans
    const double a = random.uniform(0, 3), b = random.uniform(0, 1);
    points.insert(points.end(), {0.6 * a - 7, 0.8 * a + 0.48 * b, 0.6 * b});
  }
  const BasePlaces base = project_to_plane(points);
  ASSERT_EQ(base.at.size(), 80u);
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (int i = 0; i < 40; ++i) {
    for (int d = 0; d < 2; ++d)
      low[d] = std::min(low[d], base.at[2 * i + d]), high[d] = std::max(high[d], base.at[2 * i + d]);
    for (int j = 0; j < i; ++j)
      EXPECT_NEAR(distance(&base.at[2 * i], &base.at[2 * j], 2), distance(&points[3 * i], &points[3 * j], 3),
                  1e-12);
  }
  EXPECT_GT(high[0] - low[0], high[1] - low[1]) << "the longer side first";
}

TEST(ProjectToPlane, RefusesPointsOnOneLine) {
  std::vector<double> line;
  for (int k = 0; k < 20; ++k) line.insert(line.end(), {1.0 * k, 2.0 * k, -1.0 * k});
  EXPECT_THROW(project_to_plane(line), InvalidInput);
  EXPECT_THROW(project_to_plane(std::vector<double>(30, 1.5)), InvalidInput);
}

TEST(ProjectToCylinder, UnrollsOne) {
  Random random;
  std::vector<double> points;
  std::vector<Vector> normals;
  std::vector<std::array<double, 2>> flat;  // angle times radius, height
  for (int k = 0; k < 300; ++k) {
    const double a = random.uniform(-2, 2), h = random.uniform(0, 5);
    points.insert(points.end(), {4 + 1.5 * std::cos(a), 1.5 * std::sin(a), h});
    normals.push_back({std::cos(a), std::sin(a), 0});
    flat.push_back({1.5 * a, h});
  }
  const BasePlaces base = project_to_cylinder(points, normals);
  EXPECT_NEAR(base.radius, 1.5, 1e-6);
  EXPECT_NEAR(std::abs(base.axis[2]), 1, 1e-6);
  for (std::size_t i = 1; i < flat.size(); ++i)
    EXPECT_NEAR(distance(&base.at[2 * i], &base.at[0], 2), distance(flat[i].data(), flat[0].data(), 2), 1e-5);
}

}  // namespace
}  // namespace knotfit::cloud
