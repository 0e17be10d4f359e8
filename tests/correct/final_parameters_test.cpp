#include "correct/final_parameters.h"

#include <gtest/gtest.h>

#include "support/random_splines.h"
namespace knotfit::correction {
namespace {

using namespace knotfit::test;

/// The square in n x n pairs of triangles, lines bent and drawn together.
struct Square {
  explicit Square(int n) {
    const auto at = [n](int i, int j) { return static_cast<std::int32_t>(i * (n + 1) + j); };
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
        uv.push_back(x * x * (3 - 2 * x) * 0.6 + 0.4 * x);
        uv.push_back(y + 0.1 * std::sin(3.14159265358979 * y) * std::sin(5 * x));
        const bool on_u = i == 0 || i == n, on_v = j == 0 || j == n;
        slide.push_back(on_u && on_v ? Slide::fixed
                        : on_u       ? Slide::along_v
                        : on_v       ? Slide::along_u
                                     : Slide::free);
        if (on_u) uv[uv.size() - 2] = i / n;
        if (on_v) uv.back() = j / n;
      }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  int turned(const std::vector<double>& at) const {
    int count = 0;
    for (const auto& t : faces) {
      const double *a = &at[2 * t[0]], *b = &at[2 * t[1]], *c = &at[2 * t[2]];
      count += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0;
    }
    return count;
  }
  std::vector<std::array<std::int32_t, 3>> faces;
  std::vector<double> uv;
  std::vector<Slide> slide;
};

TEST(Untangle, LeavesNoTriangleTurnedOverAndFarVerticesAlone) {
  const Square square(40);
  ASSERT_EQ(square.turned(square.uv), 0);
  Random random;
  for (int trial = 0; trial < 20; ++trial) {
    // A disk of vertices turned by half a circle: no vertex by itself can mend that.
    const double u = random.uniform(0.3, 0.7), v = random.uniform(0.3, 0.7),
                 radius = random.uniform(0.03, 0.12);
    std::vector<double> uv = square.uv;
    std::vector<char> far(square.slide.size(), 1);
    for (std::size_t k = 0; k < far.size(); ++k) {
      const double x = uv[2 * k] - u, y = uv[2 * k + 1] - v;
      far[k] = std::hypot(x, y) > 2.5 * radius + 0.1;
      if (std::hypot(x, y) > radius) continue;
      uv[2 * k] = u - x;
      uv[2 * k + 1] = v - y;
    }
    const std::vector<double> tangled = uv;
    ASSERT_GT(square.turned(tangled), 0);
    EXPECT_TRUE(untangle(square.faces, square.slide, square.uv, uv));
    EXPECT_EQ(square.turned(uv), 0);
    for (std::size_t k = 0; k < far.size(); ++k)
      if (far[k]) {
        EXPECT_EQ(uv[2 * k], tangled[2 * k]);
        EXPECT_EQ(uv[2 * k + 1], tangled[2 * k + 1]);
      }
  }
}

TEST(Untangle, SlidesBorderVerticesAlongTheirSide) {
  const Square square(20);
  std::vector<double> uv = square.uv;
  for (int j = 6; j < 12; ++j) uv[2 * j + 1] = square.uv[2 * (17 - j) + 1];  // out of order along u = 0
  ASSERT_GT(square.turned(uv), 0);
  EXPECT_TRUE(untangle(square.faces, square.slide, square.uv, uv));
  EXPECT_EQ(square.turned(uv), 0);
  for (std::size_t k = 0; k < square.slide.size(); ++k) {
    const bool u = square.slide[k] == Slide::along_v || square.slide[k] == Slide::fixed,
               v = square.slide[k] == Slide::along_u || square.slide[k] == Slide::fixed;
    if (u) {
      EXPECT_EQ(uv[2 * k], square.uv[2 * k]);
    }
    if (v) {
      EXPECT_EQ(uv[2 * k + 1], square.uv[2 * k + 1]);
    }
  }
}

TEST(Untangle, LeavesWhatTheMapHadWrong) {
  Square square(6);
  std::swap(square.uv[2 * 24], square.uv[2 * 25]);  // two neighbours of one row
  std::swap(square.uv[2 * 24 + 1], square.uv[2 * 25 + 1]);
  ASSERT_GT(square.turned(square.uv), 0);
  std::vector<double> uv = square.uv;
  EXPECT_TRUE(untangle(square.faces, square.slide, square.uv, uv));
  EXPECT_EQ(uv, square.uv);
}

TEST(ApproachFeet, TakesVerticesThatLagBehindToTheirFootPoints) {
  const Square square(30);
  const Surface plane(KnotVector::uniform(1, 0), KnotVector::uniform(1, 0), 3,
                      {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0});
  std::vector<Vec3> position;
  for (std::size_t k = 0; k < square.slide.size(); ++k)
    position.push_back({square.uv[2 * k], square.uv[2 * k + 1], 1e-3});
  const std::vector<double> distance(square.slide.size(), 1e-3);
  Random random;
  for (int trial = 0; trial < 10; ++trial) {
    // A disk of vertices drawn together towards its middle: none is turned over, all are far from their places.
    const double u = random.uniform(0.3, 0.7), v = random.uniform(0.3, 0.7), radius = 0.25;
    std::vector<double> uv = square.uv;
    for (std::size_t k = 0; k < square.slide.size(); ++k) {
      const double x = uv[2 * k] - u, y = uv[2 * k + 1] - v, r = std::hypot(x, y);
      if (r > radius) continue;
      const double nearer = 0.2 + 0.8 * r / radius;
      uv[2 * k] = u + nearer * x, uv[2 * k + 1] = v + nearer * y;
    }
    ASSERT_EQ(square.turned(uv), 0);
    EXPECT_GT(approach_feet(square.faces, position, square.slide, square.uv, distance, plane, uv), 10);
    EXPECT_EQ(square.turned(uv), 0);
    for (std::size_t k = 0; k < square.slide.size(); ++k)
      EXPECT_LT(std::hypot(uv[2 * k] - square.uv[2 * k], uv[2 * k + 1] - square.uv[2 * k + 1]), 3e-3);
  }
  // One whose foot lies beyond its neighbours goes as far as they let it, and one without data stays.
  std::vector<double> uv = square.uv, feet = square.uv;
  feet[2 * 200] += 0.2;
  position[200].x += 0.2;
  feet[2 * 500] = NAN;
  const std::vector<double> there(uv.begin() + 1000, uv.begin() + 1002);
  EXPECT_EQ(approach_feet(square.faces, position, square.slide, feet, distance, plane, uv), 1);
  EXPECT_EQ(square.turned(uv), 0);
  EXPECT_GT(uv[400], square.uv[400]);
  EXPECT_LT(uv[400], feet[400]);
  EXPECT_EQ(std::vector<double>(uv.begin() + 1000, uv.begin() + 1002), there);
}

}  // namespace
}  // namespace knotfit::correction
