#include "parameterize/cloud_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "clouds.h"
#include "knotfit/parameterize_cloud.h"
#include "parameterize/cloud_neighbours.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

/// Lines around an axis: `points` a line over an arc, `lines` of them `ratio` times as far apart.
Points arcs(int points, int lines, double arc, double ratio, Random* noise = nullptr) {
  Points p;
  const double radius = 30, step = arc / (points - 1);
  for (int j = 0; j < lines; ++j)
    for (int i = 0; i < points; ++i) {
      const auto off = [&](double most) { return noise != nullptr ? noise->uniform(-most, most) : 0; };
      const double t = step * (i + off(0.3)), h = ratio * radius * step * (j + off(0.005)),
                   r = radius + off(0.02);
      p.insert(p.end(), {r * std::cos(t), r * std::sin(t), h});
    }
  return p;
}

/// Every cell of a grid is two triangles, its rim the outline, and nothing else.
void expect_all_cells(const Points& p, int columns, int rows) {
  const CloudMap c = parameterize_cloud(p, {.base = CloudBase::graph, .map = {.newton = false}});
  EXPECT_EQ(c.mesh.face_count(), 2 * (columns - 1) * (rows - 1));
  EXPECT_EQ(std::count(c.mesh.virtual_face.begin(), c.mesh.virtual_face.end(), 1), 0);
  EXPECT_EQ(c.lone, 0);
  EXPECT_EQ(c.openings.size(), 0u);
  EXPECT_EQ(c.map.quality.flipped, 0);
  const MeshReport report = inspect(c.mesh);
  EXPECT_TRUE(report.disk());
  EXPECT_EQ(report.loop_edges, (std::vector<Index>{2 * (columns + rows - 2)}));
  // The corners of the grid are those of the square, and its sides the square's sides.
  std::set<Index> corners;
  for (const Index v : c.map.corners) corners.insert(c.mesh.vertex_line[v]);
  EXPECT_EQ(corners, (std::set<Index>{1, columns, Index{columns} * (rows - 1) + 1, Index{columns} * rows}));
}

TEST(CloudGraph, RegularGridsAreJoinedCellByCell) {
  for (const bool flat : {false, true})
    for (const double step : {1.0, 3.0, 7.0, 10.0})
      for (const double angle : {0.0, 0.5})
        for (const double far : {0.0, 5e6}) {
          if (flat && far > 0) continue;
          SCOPED_TRACE(std::to_string(flat) + " " + std::to_string(step) + " " + std::to_string(angle) + " " +
                       std::to_string(far));
          expect_all_cells(wave_grid(40, 40, 1, step, angle, far, flat), 40, 40);
          if (step > 1) expect_all_cells(wave_grid(24, 30, step, 1, angle, far, flat), 24, 30);
        }
}

TEST(CloudGraph, FlatGridsKeepTheirSpacing) {
  const Points p = wave_grid(40, 40, 1, 10, 0.5, 0, true);
  const CloudMap c = parameterize_cloud(p, {.base = CloudBase::graph});
  // Up to a turn by quarters: of each cell's edges one parameter stays, the other steps by 1/39.
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i + 1 < 40; ++i) {
      std::array<Index, 2> at{};
      for (int k = 0; k < 2; ++k)
        at[k] = std::find(c.mesh.vertex_line.begin(), c.mesh.vertex_line.end(), 40 * j + i + k + 1) -
                c.mesh.vertex_line.begin();
      const double du = std::abs(c.map.uv[2 * at[1]] - c.map.uv[2 * at[0]]),
                   dv = std::abs(c.map.uv[2 * at[1] + 1] - c.map.uv[2 * at[0] + 1]);
      EXPECT_NEAR(std::max(du, dv), 1.0 / 39, 1e-6);
      EXPECT_NEAR(std::min(du, dv), 0, 1e-6);
    }
}

TEST(CloudGraph, LinesOfAScannerThatFoldOverAnyPlane) {
  Random random;
  for (const double ratio : {5.0, 10.0, 20.0})
    for (const bool noisy : {false, true}) {
      if (noisy && ratio > 10) continue;
      SCOPED_TRACE(std::to_string(ratio) + (noisy ? " noisy" : ""));
      const Points p = arcs(240, 20, 4.4, ratio, noisy ? &random : nullptr);
      const CloudMap c = parameterize_cloud(p);  // no base named
      EXPECT_EQ(c.base, CloudBase::graph);
      EXPECT_GT(c.folded, 0.1);
      EXPECT_EQ(c.openings.size(), 0u);
      EXPECT_LE(c.lone, noisy ? 5 : 0);
      EXPECT_EQ(c.map.quality.flipped, 0);
      // One parameter goes along the arc, the other from line to line: each is a function of one of them.
      double worst = 0;
      for (Index v = 0; v < c.mesh.vertex_count(); ++v) {
        if (c.mesh.vertex_line[v] == 0) continue;
        const Index k = c.mesh.vertex_line[v] - 1;
        const double along = static_cast<double>(k % 240) / 239, across = static_cast<double>(k / 240) / 19;
        const double u = c.map.uv[2 * v], w = c.map.uv[2 * v + 1];
        const auto off = [](double a, double b) { return std::min(std::abs(a - b), std::abs(1 - a - b)); };
        worst = std::max(worst, std::min(std::max(off(u, along), off(w, across)),
                                         std::max(off(w, along), off(u, across))));
      }
      EXPECT_LT(worst, 0.03);
    }
}

TEST(CloudOverAPlane, LinesOfAScannerLoseNoPoints) {
  // Foreshortened at both ends: the points there are 50 times as dense along as across.
  for (const double ratio : {10.0, 15.0}) {
    const CloudMap c = parameterize_cloud(arcs(200, 25, 2.6, ratio));
    EXPECT_EQ(c.base, CloudBase::plane);
    EXPECT_EQ(c.lone, 0);
    EXPECT_LT(c.folded, 0.01);
    EXPECT_EQ(c.openings.size(), 0u);
    EXPECT_GT(c.covered, 0.99);
  }
}

}  // namespace
}  // namespace knotfit::test
