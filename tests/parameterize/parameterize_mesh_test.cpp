#include "knotfit/parameterize_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "knotfit/exceptions.h"
#include "mesh_support.h"
#include "support/expect_throw.h"
#include "support/two_threads.h"
namespace knotfit {
namespace {

using test::expect_throw;

std::set<Index> boundary_vertices(const Mesh& mesh) {
  std::set<std::pair<Index, Index>> open;
  for (const auto& f : mesh.faces)
    for (int k = 0; k < 3; ++k) {
      const Index a = f[k], b = f[(k + 1) % 3];
      if (!open.erase({b, a})) open.insert({a, b});
    }
  std::set<Index> vertices;
  for (const auto& [a, b] : open) vertices.insert({a, b});
  return vertices;
}

// What every map promises: parameters in the square, boundary vertices on its sides, corners at its corners,
// no triangle flat or turned where edges are halved as told.
void expect_sound(const Mesh& mesh, const MeshMap& map) {
  ASSERT_EQ(static_cast<Index>(map.uv.size()), 2 * mesh.vertex_count());
  for (const double x : map.uv) ASSERT_TRUE(x >= 0 && x <= 1);
  for (const Index k : boundary_vertices(mesh)) {
    const double u = map.uv[2 * k], v = map.uv[2 * k + 1];
    EXPECT_TRUE(u == 0 || u == 1 || v == 0 || v == 1) << "vertex " << k << ": " << u << ", " << v;
  }
  const double square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < 4; ++k)
    for (int c = 0; c < 2; ++c) EXPECT_EQ(map.uv[2 * map.corners[k] + c], square[k][c]);
  EXPECT_EQ(map.quality.flipped, 0);
  const Mesh halved = halve_edges(mesh, map.halved_edges);
  const MapQuality quality = measure_map(halved, map.all_uv());
  EXPECT_EQ(quality.flipped, 0);
  EXPECT_NEAR(quality.stretch, map.quality.stretch, 1e-9 * quality.stretch);  // needles magnify rounding
  EXPECT_GT(map.quality.worst_angle, 0);
  EXPECT_LE(map.quality.worst_angle, 90 + 1e-12);
  EXPECT_LE(map.trial_distance, map.trial_error);
}

TEST(ParameterizeMesh, IsSoundOnMadeMeshes) {
  Mesh lone = test::sheet(1, 1);
  for (const Mesh& mesh :
       {lone, test::sheet(3, 2), test::bump(20), test::dome(8, 30, 2), test::dome(1, 5, 0.3)}) {
    const MeshMap map = parameterize_mesh(mesh);
    expect_sound(mesh, map);
    EXPECT_FALSE(map.stopped);
  }
}

TEST(ParameterizeMesh, FlatRectangleComesOutAsIs) {
  const Mesh mesh = test::sheet(20, 10, 4, 2, {}, 0.3);
  const MeshMap map = parameterize_mesh(mesh, {.omega = 0});
  expect_sound(mesh, map);
  EXPECT_NEAR(map.quality.aspect_free_stretch, 1, 1e-4);
  EXPECT_NEAR(std::max(map.quality.aspect, 1 / map.quality.aspect), 2, 1e-3);
  // L2 on the square of a 2 x 1 sheet: sqrt((4 + 1) / (2 2)).
  EXPECT_NEAR(map.quality.stretch, std::sqrt(1.25), 1e-3);
}

TEST(ParameterizeMesh, NeverStretchesMoreThanTheMeanValueMap) {
  for (const Mesh& mesh : {test::bump(24), test::dome(10, 40, 1.5)})
    for (const CornerRule rule : {CornerRule::sharpest, CornerRule::search}) {
      const MeshMap plain = parameterize_mesh(mesh, {.corners = rule, .omega = 0});
      const MeshMap start = parameterize_mesh(mesh, {.corners = rule, .omega = 0, .newton = false});
      expect_sound(mesh, start);
      EXPECT_LE(plain.quality.stretch, start.quality.stretch);
      EXPECT_EQ(plain.rule, rule);
    }
}

TEST(ParameterizeMesh, TakesTheCornersGiven) {
  const Mesh mesh = test::bump(12);  // 13 x 13, counter-clockwise: 0, 12, 168, 156
  const std::array<Index, 4> corners = {5, 38, 165, 130};
  const MeshMap map = parameterize_mesh(mesh, {.corner_vertices = corners});
  EXPECT_EQ(map.corners, corners);
  expect_sound(mesh, map);
}

TEST(ParameterizeMesh, NamesBadCorners) {
  const Mesh mesh = test::bump(12);
  const auto with = [&](std::array<Index, 4> corners) {
    return [&mesh, corners] { parameterize_mesh(mesh, {.corner_vertices = corners}); };
  };
  expect_throw<InvalidInput>(with({0, 12, 168, 200}), "corner 4: there is no vertex 200; the mesh has 169");
  expect_throw<InvalidInput>(with({-1, 12, 168, 156}), "corner 1: there is no vertex -1");
  expect_throw<InvalidInput>(with({0, 80, 168, 156}), "corner 2: vertex 80 is not on the boundary");
  expect_throw<InvalidInput>(with({0, 12, 12, 156}), "corners 2 and 3 are both vertex 12");
  expect_throw<InvalidInput>(with({0, 156, 168, 12}), "in order they are 0, 12, 168, 156");
}

TEST(ParameterizeMesh, NamesBadOptionsAndMeshes) {
  const Mesh mesh = test::bump(6);
  expect_throw<InvalidInput>([&] { parameterize_mesh(mesh, {.omega = 11}); }, "omega = 11");
  expect_throw<InvalidInput>([&] { parameterize_mesh(mesh, {.omega = NAN}); }, "omega = nan");
  expect_throw<InvalidInput>([&] { parameterize_mesh(mesh, {.newton_rounds = -1}); }, "-1 rounds of Newton");
  Mesh two = mesh;
  two.faces.pop_back();
  two.faces.erase(two.faces.begin() + 30);
  EXPECT_THROW(parameterize_mesh(two), InvalidInput);  // two loops: require_disk names them
  Mesh triangle;
  triangle.vertices = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  triangle.faces = {{0, 1, 2}};
  expect_throw<InvalidInput>([&] { parameterize_mesh(triangle); }, "the boundary has 3 vertices");
}

TEST(ParameterizeMesh, GivesTheSameBitsForOneAndTwoThreads) {
  const Mesh mesh = test::dome(9, 36, 1);
  const auto [one, two] = test::on_one_and_two_threads([&] { return parameterize_mesh(mesh); });
  EXPECT_EQ(one.uv, two.uv);
  EXPECT_EQ(one.corners, two.corners);
  EXPECT_EQ(one.omega, two.omega);
  EXPECT_EQ(one.trial_distance, two.trial_distance);
}

TEST(ParameterizeMesh, IsTheSameAtAnyScaleAndPlace) {
  const Mesh mesh = test::bump(10);
  Mesh moved = mesh;
  for (std::size_t k = 0; k < moved.vertices.size(); ++k) moved.vertices[k] = 1024 * (moved.vertices[k] + 4);
  const MeshMap a = parameterize_mesh(mesh, {.omega = 0.05}), b = parameterize_mesh(moved, {.omega = 0.05});
  EXPECT_EQ(a.corners, b.corners);
  for (std::size_t k = 0; k < a.uv.size(); ++k) EXPECT_NEAR(a.uv[k], b.uv[k], 1e-9);
}

TEST(ParameterizeMesh, LeavesVirtualFacesOutOfWhatItMeasures) {
  Mesh mesh = test::bump(12);
  Mesh holed = mesh;
  holed.virtual_face.assign(holed.faces.size(), 0);
  std::set<std::int32_t> of_hole;
  for (std::size_t f = 0; f < holed.faces.size(); ++f) {
    bool inside = true;
    for (const std::int32_t i : holed.faces[f]) {
      const double* p = holed.vertex(i);
      inside = inside && p[0] > 0.3 && p[0] < 0.7 && p[1] > 0.3 && p[1] < 0.7;
    }
    holed.virtual_face[f] = inside;
  }
  const MeshMap map = parameterize_mesh(holed, {.omega = 0}), plain = parameterize_mesh(mesh, {.omega = 0});
  expect_sound(holed, map);
  EXPECT_LE(map.quality.stretch, plain.quality.stretch);  // the steep part does not count
  EXPECT_LT(mesh_points(holed, map.uv).size(), mesh.vertex_count());
}

TEST(ParameterizeMesh, StopsWithASoundMap) {
  const Mesh mesh = test::dome(10, 40, 2);
  std::stop_source source;
  source.request_stop();
  Control control;
  control.stop = source.get_token();
  const MeshMap map = parameterize_mesh(mesh, {}, control);
  EXPECT_TRUE(map.stopped);
  expect_sound(mesh, map);
}

TEST(ParameterizeMesh, ReportsItsProgress) {
  std::vector<double> fractions;
  Control control;
  control.progress = [&](const Progress& p) {
    EXPECT_EQ(p.stage, "map");
    fractions.push_back(p.fraction);
  };
  parameterize_mesh(test::bump(8), {}, control);
  ASSERT_GE(fractions.size(), 3u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_EQ(fractions.back(), 1);
}

struct Scan {
  const char* name;
  double stretch, distance;  // most allowed of the plain map; of the default one, 0: not asked
};

class Scans : public ::testing::TestWithParam<Scan> {
 protected:
  void SetUp() override {
    if (!std::getenv("KNOTFIT_DATA")) GTEST_SKIP() << "KNOTFIT_DATA is not set";
  }
};

TEST_P(Scans, AreMappedWithoutAFlipAndWithLittleStretch) {
  const Mesh mesh = test::read_mesh(GetParam().name);
  const MeshMap plain = parameterize_mesh(mesh, {.corners = CornerRule::sharpest, .omega = 0});
  const MeshMap start =
      parameterize_mesh(mesh, {.corners = CornerRule::sharpest, .omega = 0, .newton = false});
  expect_sound(mesh, plain);
  expect_sound(mesh, start);
  EXPECT_LE(plain.quality.stretch, GetParam().stretch);
  EXPECT_LE(plain.quality.stretch, start.quality.stretch);
  if (GetParam().distance == 0) return;
  const MeshMap map = parameterize_mesh(mesh);
  expect_sound(mesh, map);
  EXPECT_EQ(measure_map(mesh, map.uv).flipped, 0);  // not even with its edges whole
  EXPECT_LE(map.trial_distance, GetParam().distance);
}

// Distances of the default map's fit of 20 x 20: what was asked for. Those of the other large meshes take too
// long here and are in scripts/parameterization, which fails where one is missed.
INSTANTIATE_TEST_SUITE_P(
    Real, Scans,
    ::testing::Values(Scan{"face.obj", 1.15, 2.3e-3}, Scan{"three_peaks.off", 1.25, 4.5e-4},
                      Scan{"mask.obj", 1.1, 1.2e-3}, Scan{"horizon.off", 1.005, 2e-4},
                      Scan{"cowhead.obj", 1.45, 0}, Scan{"hammer_half.ply", 1.85, 0},
                      Scan{"cylinder_uneven.off", 1.001, 0}, Scan{"skull_top.ply", 1.2, 0},
                      Scan{"mountain.ply", 1.2, 0}, Scan{"blade_patch.ply", 1.02, 0},
                      Scan{"demosthenes_front.ply", 1.35, 0}, Scan{"blade_half.ply", 1.55, 0}),
    [](const auto& scan) {
      std::string name = scan.param.name;
      return name.substr(0, name.find('.'));
    });

}  // namespace
}  // namespace knotfit
