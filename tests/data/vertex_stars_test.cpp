#include "data/vertex_stars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>
namespace knotfit::test {
namespace {

TEST(VertexStars, AreTheTrianglesThatHaveTheVertex) {
  // A fan around vertex 0 of more triangles than one chunk of the sort, and a vertex of none.
  const std::int32_t n = 5000;
  std::vector<std::array<std::int32_t, 3>> faces;
  for (std::int32_t k = 1; k < n; ++k) faces.push_back({k % 3 == 0 ? k : 0, k % 3 == 0 ? 0 : k, k + 1});
  const VertexStars stars(faces, n + 2);
  for (std::int32_t v = 0; v < n + 2; v += v < 3 ? 1 : 97) {
    std::vector<std::int32_t> expected;
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (std::count(faces[f].begin(), faces[f].end(), v) > 0)
        expected.push_back(static_cast<std::int32_t>(f));
    const auto star = stars.of(v);
    EXPECT_EQ(std::vector<std::int32_t>(star.begin(), star.end()), expected) << "vertex " << v;
  }
  EXPECT_TRUE(stars.of(n + 1).empty());
}

}  // namespace
}  // namespace knotfit::test
