#include "parameterize/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using cloud::delaunay;
using cloud::Place;
using cloud::Triangulation;

constexpr std::int64_t kMost = std::int64_t{1} << cloud::kGridBits;

/// Sign of how far d is inside the circle through a, b, c: in 256 bits' worth of long double parts, here by the
/// definition with a rational centre kept whole.
int inside(const Place& a, const Place& b, const Place& c, const Place& d) {
  __extension__ using Wide = __int128;
  const auto x = [&](const Place& p) { return Wide(p[0] - d[0]); };
  const auto y = [&](const Place& p) { return Wide(p[1] - d[1]); };
  const auto lift = [&](const Place& p) { return x(p) * x(p) + y(p) * y(p); };
  const Wide det = lift(a) * (x(b) * y(c) - y(b) * x(c)) - lift(b) * (x(a) * y(c) - y(a) * x(c)) +
                   lift(c) * (x(a) * y(b) - y(a) * x(b));
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

/// Twice the area of the convex hull, by the gift-wrapping of a slow test.
std::int64_t hull_area(std::vector<Place> p) {
  std::sort(p.begin(), p.end());
  p.erase(std::unique(p.begin(), p.end()), p.end());
  std::vector<Place> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const Place& q : p) {
      while (hull.size() >= base + 2 && cloud::area(hull[hull.size() - 2], hull.back(), q) <= 0)
        hull.pop_back();
      hull.push_back(q);
    }
    hull.pop_back();
    std::reverse(p.begin(), p.end());
  }
  std::int64_t sum = 0;
  for (std::size_t k = 1; k + 1 < hull.size(); ++k) sum += cloud::area(hull[0], hull[k], hull[k + 1]);
  return sum;
}

void expect_delaunay(const std::vector<Place>& places) {
  const Triangulation t = delaunay(places);
  ASSERT_EQ(t.used.size(), places.size());
  std::set<Place> distinct(places.begin(), places.end());
  EXPECT_EQ(std::count(t.used.begin(), t.used.end(), 1), static_cast<Index>(distinct.size()));
  std::set<std::int32_t> met;
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> edge;
  std::int64_t sum = 0;
  for (std::size_t f = 0; f < t.triangle.size(); ++f) {
    const auto& [a, b, c] = t.triangle[f];
    const std::int64_t twice = cloud::area(places[a], places[b], places[c]);
    EXPECT_GT(twice, 0);
    sum += twice;
    for (int k = 0; k < 3; ++k) {
      met.insert(t.triangle[f][k]);
      EXPECT_TRUE(edge.emplace(std::pair(t.triangle[f][(k + 1) % 3], t.triangle[f][(k + 2) % 3]), f).second);
    }
  }
  EXPECT_EQ(met.size(), distinct.size());
  EXPECT_EQ(sum, hull_area(places));
  // The circle of a triangle is empty of the corner across each edge: so it is of all places [Lawson77].
  for (std::size_t f = 0; f < t.triangle.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const auto across = edge.find({t.triangle[f][(k + 2) % 3], t.triangle[f][(k + 1) % 3]});
      EXPECT_EQ(t.beside[f][k], across == edge.end() ? -1 : static_cast<std::int32_t>(across->second));
      if (across == edge.end()) continue;
      for (const std::int32_t d : t.triangle[across->second])
        EXPECT_LE(
            inside(places[t.triangle[f][0]], places[t.triangle[f][1]], places[t.triangle[f][2]], places[d]),
            0);
    }
}

TEST(Delaunay, OfRandomPlaces) {
  Random random;
  for (int run = 0; run < 200; ++run) {
    // From crowded grids, where four places on a circle are the rule, to the whole range.
    const int side = run % 4 == 0 ? 5 : run % 4 == 1 ? 40 : static_cast<int>(kMost);
    std::vector<Place> places;
    for (int k = random.integer(3, 150); k > 0; --k)
      places.push_back({random.integer(0, side), random.integer(0, side)});
    if (hull_area(places) > 0) expect_delaunay(places);
  }
}

TEST(Delaunay, OfGridsAndLines) {
  std::vector<Place> grid, far;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 9; ++j) {
      grid.push_back({i * 1000, j * 1000});
      far.push_back({i % 2 == 0 ? 0 : kMost, j * (kMost / 8)});
    }
  expect_delaunay(grid);
  expect_delaunay(far);
  std::vector<Place> line;
  for (int i = 0; i < 20; ++i) line.push_back({i * 7, i * 3});
  EXPECT_TRUE(delaunay(line).triangle.empty());
  line.push_back({1, 0});
  expect_delaunay(line);
  line.push_back({140, 60});  // further along the line
  expect_delaunay(line);
  EXPECT_TRUE(delaunay({}).triangle.empty());
  EXPECT_TRUE(delaunay({{1, 1}, {1, 1}, {1, 1}, {2, 1}}).triangle.empty());
}

TEST(Delaunay, DoesNotDependOnWhatIsEqual) {
  const std::vector<Place> once = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {3, 4}};
  std::vector<Place> twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  EXPECT_EQ(delaunay(once).triangle, delaunay(twice).triangle);
  EXPECT_EQ(delaunay(twice).used, (std::vector<char>{1, 1, 1, 1, 1, 0, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace knotfit::test
