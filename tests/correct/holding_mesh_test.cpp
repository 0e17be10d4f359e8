#include "correct/holding_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "correct/flat_mesh.h"
#include "data/orientation.h"
namespace knotfit::correction {
namespace {

double area(const HoldingMesh& m, bool plane) {
  double sum = 0;
  for (const auto& t : m.face) {
    const Vec3 normal = cross(m.position[t[1]] - m.position[t[0]], m.position[t[2]] - m.position[t[0]]);
    sum += (plane ? twice_area(m.uv, t) : length(normal)) / 2;
  }
  return sum;
}

TEST(HoldingMesh, HalvingLeavesTheMapAsItIs) {
  HoldingMesh m = flat(4, 3, 2);
  m.virtual_face[5] = 1;
  const Index before = m.size();
  halve_long_edges(m, 0.11, 0.06);
  EXPECT_GT(m.size(), before);
  EXPECT_NEAR(area(m, true), 1, 1e-12);
  EXPECT_NEAR(area(m, false), 6, 1e-12);
  double closing = 0;
  for (std::size_t f = 0; f < m.face.size(); ++f) {
    const auto& t = m.face[f];
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(std::abs(m.uv[2 * t[k]] - m.uv[2 * t[(k + 1) % 3]]), 0.11);
      EXPECT_LE(std::abs(m.uv[2 * t[k] + 1] - m.uv[2 * t[(k + 1) % 3] + 1]), 0.06);
    }
    if (m.virtual_face[f]) closing += 1;
  }
  EXPECT_GT(closing, 1);
  for (Index k = 0; k < m.size(); ++k)
    EXPECT_NEAR(length(m.position[k] - Vec3{3 * m.uv[2 * k], 2 * m.uv[2 * k + 1], 0}), 0, 1e-14);
  // The border still goes round: every vertex of it once from, once to.
  std::vector<int> out(static_cast<std::size_t>(m.size()), 0), in = out;
  for (const auto& [a, b] : m.border) ++out[a], ++in[b];
  EXPECT_EQ(out, in);
  EXPECT_EQ(m.border.size(), static_cast<std::size_t>(std::count(out.begin(), out.end(), 1)));
}

TEST(HoldingMesh, BorderVerticesSlideAlongTheirSides) {
  const HoldingMesh m = flat(3);
  const std::vector<Slide> s = slides(m, true, false), still = slides(m, false, false),
                           round = slides(m, true, true);
  for (Index k = 0; k < m.size(); ++k) {
    const bool u = m.uv[2 * k] == 0 || m.uv[2 * k] == 1, v = m.uv[2 * k + 1] == 0 || m.uv[2 * k + 1] == 1;
    EXPECT_EQ(s[k], u && v ? Slide::fixed : u ? Slide::along_v : v ? Slide::along_u : Slide::free);
    EXPECT_EQ(still[k], u || v ? Slide::fixed : Slide::free);
    EXPECT_EQ(round[k], u || v ? Slide::round : Slide::free);
  }
}

TEST(HoldingMesh, WeightsOfTheDataSumToOne) {
  HoldingMesh m = flat(4);
  const Index own = m.size();
  halve_long_edges(m, 0.13, 0.13);
  PointWeights w = point_weights(m);
  weigh_added(m, 0.3, w);
  double data = 0, added = 0, parts = 0;
  for (std::size_t i = 0; i < w.vertex.size(); ++i) {
    EXPECT_EQ(w.data[i] != 0, w.vertex[i] < own);
    (w.data[i] ? data : added) += w.weight[i];
    parts += w.area[i];
  }
  EXPECT_NEAR(data, 1, 1e-12);
  EXPECT_NEAR(parts, 1, 1e-12);
  EXPECT_GT(added, 0);
  EXPECT_LE(added, 0.3);
}

}  // namespace
}  // namespace knotfit::correction
