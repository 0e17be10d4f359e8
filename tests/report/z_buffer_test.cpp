#include "report/z_buffer.h"

#include <gtest/gtest.h>

#include <random>

#include "knotfit/threads.h"
namespace knotfit::report {
namespace {

struct Soup {
  std::vector<ScreenPoint> corners;
  std::vector<Triangle> triangles;
};

Soup random_soup(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-20, 120), near(0.05, 0.2);
  Soup soup;
  for (int k = 0; k < count; ++k) {
    for (int c = 0; c < 3; ++c) soup.corners.push_back({place(random), place(random), near(random)});
    soup.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  return soup;
}

TEST(ZBuffer, AgreesWithEveryPixelAskedOfEveryTriangle) {
  const Soup soup = random_soup(40, 3);
  const ZBuffer buffer(100, 90, soup.corners, soup.triangles);
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 100; ++x) {
      int best = -1;
      float nearest = 0;
      for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
        const ScreenPoint &a = soup.corners[3 * k], &b = soup.corners[3 * k + 1],
                          &c = soup.corners[3 * k + 2];
        auto side = [&](const ScreenPoint& p, const ScreenPoint& q) {
          return (q.x - p.x) * (y + 0.5 - p.y) - (q.y - p.y) * (x + 0.5 - p.x);
        };
        const double wa = side(b, c), wb = side(c, a), wc = side(a, b), area = wa + wb + wc;
        if (area == 0 || wa / area < 0 || wb / area < 0 || wc / area < 0) continue;
        const auto n = static_cast<float>((wa * a.nearness + wb * b.nearness + wc * c.nearness) / area);
        if (n > nearest) {
          nearest = n;
          best = static_cast<int>(k);
        }
      }
      ASSERT_EQ(buffer.triangle(x, y), best) << x << ", " << y;
      ASSERT_NEAR(buffer.nearness(x, y), nearest, 1e-6);
    }
}

TEST(ZBuffer, IsTheSameForOneAndTwoThreads) {
  const Soup soup = random_soup(500, 5);
  set_thread_count(1);
  const ZBuffer one(100, 100, soup.corners, soup.triangles);
  set_thread_count(2);
  const ZBuffer two(100, 100, soup.corners, soup.triangles);
  set_thread_count(0);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) ASSERT_EQ(one.triangle(x, y), two.triangle(x, y));
}

TEST(ZBuffer, LeavesNoCrackBetweenNeighbours) {
  // A fan about a point that no pixel centre avoids exactly.
  std::vector<ScreenPoint> corners{{50.5, 50.5, 0.1}};
  std::vector<Triangle> triangles;
  for (int k = 0; k < 37; ++k)
    corners.push_back({50.5 + 40 * std::cos(k * 0.16981), 50.5 + 40 * std::sin(k * 0.16981), 0.1});
  for (int k = 0; k < 37; ++k) triangles.push_back({0, 1 + k, 1 + (k + 1) % 37});
  const ZBuffer buffer(101, 101, corners, triangles);
  for (int y = 20; y < 80; ++y)
    for (int x = 20; x < 80; ++x)
      ASSERT_TRUE(std::hypot(x - 50, y - 50) > 38 || buffer.triangle(x, y) >= 0) << x << ", " << y;
}

TEST(ZBuffer, SkipsTrianglesWithoutAreaOrWithoutNumbers) {
  const std::vector<ScreenPoint> corners{{10, 10, 0.1}, {20, 20, 0.1}, {30, 30, 0.1}, {NAN, 5, 0.1}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 1, 3}};
  const ZBuffer buffer(40, 40, corners, triangles);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) ASSERT_EQ(buffer.triangle(x, y), -1);
}

}  // namespace
}  // namespace knotfit::report
