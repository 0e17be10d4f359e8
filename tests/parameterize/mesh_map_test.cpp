#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "data/orientation.h"
#include "mesh_support.h"
#include "parameterize/mesh_border.h"
#include "parameterize/mesh_corner_search.h"
#include "parameterize/mesh_mean_value.h"
#include "parameterize/mesh_trial_fit.h"
namespace knotfit::mesh_map {
namespace {

// Means of mean value weights reproduce every linear function on a plane [Floater03].
TEST(MeanValueMap, ReproducesLinearFunctionsOnAPlane) {
  for (const Mesh& mesh : {test::sheet(9, 7, 2, 1, {}, 0.3), test::dome(6, 17, 0)}) {
    const DiskMesh disk = make_disk(mesh);
    const Elimination elimination(disk.vertex_count(), disk.edge);
    ConvexMap map(disk, elimination);
    ASSERT_TRUE(map.factor(mean_value_weights(disk, rest_triangles(disk, 0))));
    const auto linear = [&](int i) {
      const Position& p = disk.position[i];
      return std::array<double, 2>{0.3 + 2 * p[0] - p[1], p[0] + 0.7 * p[1] - 5};
    };
    std::vector<double> uv(2 * disk.position.size(), 77);
    for (const int i : disk.loop) std::copy_n(linear(i).data(), 2, &uv[2 * i]);
    map.solve(uv);
    for (int i = 0; i < disk.vertex_count(); ++i)
      for (int c = 0; c < 2; ++c) EXPECT_NEAR(uv[2 * i + c], linear(i)[c], 1e-12) << "vertex " << i;
  }
}

TEST(MeanValueMap, MapsASquareToItself) {
  const DiskMesh disk = make_disk(test::sheet(8, 8, 1, 1, {}, 0.2));
  const Elimination elimination(disk.vertex_count(), disk.edge);
  const std::vector<RestTriangle> rest = rest_triangles(disk, 0);
  const Border border(disk, rest);
  std::vector<double> uv(2 * disk.position.size());
  // The loop starts at vertex 0, the corner at the origin.
  border.place({0, 8, 16, 24}, uv);
  ConvexMap map(disk, elimination);
  ASSERT_TRUE(map.factor(mean_value_weights(disk, rest)));
  map.solve(uv);
  const double side = std::sqrt(0.5);  // of a square of diagonal 1
  for (int i = 0; i < disk.vertex_count(); ++i)
    for (int c = 0; c < 2; ++c) EXPECT_NEAR(uv[2 * i + c], disk.position[i][c] / side, 1e-13);
}

TEST(RestTriangles, HaveTheSidesOfTheMetric) {
  const DiskMesh disk = make_disk(test::bump(9));
  for (const double omega : {0.0, 0.1}) {
    const std::vector<RestTriangle> rest = rest_triangles(disk, omega);
    for (int f = 0; f < disk.face_count(); ++f)
      for (int k = 0; k < 3; ++k) {
        const int a = disk.face[f][(k + 1) % 3], b = disk.face[f][(k + 2) % 3];
        double x2 = 0, n2 = 0;
        for (int c = 0; c < 3; ++c) {
          x2 += std::pow(disk.position[a][c] - disk.position[b][c], 2);
          n2 += std::pow(disk.normal[a][c] - disk.normal[b][c], 2);
        }
        EXPECT_NEAR(rest[f].length[k], std::sqrt(x2 + omega * omega * n2), 1e-15);
        // |p_a - p_b| = |g|-weighted: the hat functions' gradients sum to 0 and are 1 over the heights.
        EXPECT_NEAR(std::hypot(rest[f].gx[k], rest[f].gy[k]), rest[f].length[k] / (2 * rest[f].area),
                    1e-9 / rest[f].length[k]);
      }
  }
}

std::vector<double> affine(const DiskMesh& disk, double xx, double xy, double yx, double yy) {
  std::vector<double> uv;
  for (const Position& p : disk.position) uv.insert(uv.end(), {xx * p[0] + xy * p[1], yx * p[0] + yy * p[1]});
  return uv;
}

// J = diag(a, b): E = A / a^2, G = A / b^2, plane area A a b: L2^2 = (1/a^2 + 1/b^2) a b / 2, best aspect b / a.
TEST(Stretch, IsKnownOnAffineMaps) {
  const DiskMesh disk = make_disk(test::sheet(7, 5, 1, 1, {}, 0.3));
  const std::vector<RestTriangle> rest = rest_triangles(disk, 0);
  const Stretch stretched = measure_stretch(disk, rest, affine(disk, 2, 0, 0, 0.5));
  EXPECT_NEAR(stretched.square, std::sqrt((0.25 + 4) / 2), 1e-12);
  EXPECT_NEAR(stretched.aspect_free, 1, 1e-12);
  EXPECT_NEAR(stretched.aspect, 0.25, 1e-12);
  EXPECT_FALSE(stretched.flat);

  // A shear J = [1 1; 0 1]: I = [1 -1; 0 1], E = 1, G = 2.
  const Stretch sheared = measure_stretch(disk, rest, affine(disk, 1, 1, 0, 1));
  EXPECT_NEAR(sheared.square, std::sqrt(1.5), 1e-12);
  EXPECT_NEAR(sheared.aspect_free, std::sqrt(std::sqrt(2.0)), 1e-12);
  EXPECT_NEAR(sheared.aspect, std::sqrt(0.5), 1e-12);

  EXPECT_TRUE(measure_stretch(disk, rest, affine(disk, 1, 0, 0, -1)).flat);
  EXPECT_TRUE(std::isinf(measure_stretch(disk, rest, affine(disk, 1, 0, 1, 0)).cost()));
}

TEST(Border, PlacesEverySideByArcLength) {
  const DiskMesh disk = make_disk(test::sheet(6, 4, 3, 2));
  const Border border(disk, rest_triangles(disk, 0));
  const Corners corners = {2, 7, 11, 18};
  std::vector<double> uv(2 * disk.position.size(), -1);
  border.place(corners, uv);
  const auto at = [&](int k) {
    return std::array<double, 2>{uv[2 * disk.loop[k]], uv[2 * disk.loop[k] + 1]};
  };
  EXPECT_EQ(at(2), (std::array<double, 2>{0, 0}));
  EXPECT_EQ(at(7), (std::array<double, 2>{1, 0}));
  EXPECT_EQ(at(11), (std::array<double, 2>{1, 1}));
  EXPECT_EQ(at(18), (std::array<double, 2>{0, 1}));
  const double whole = border.at(7) - border.at(2);
  for (int k = 3; k < 7; ++k) {
    EXPECT_NEAR(at(k)[0], (border.at(k) - border.at(2)) / whole, 1e-15);
    EXPECT_EQ(at(k)[1], 0);
  }
  for (int k = 12; k < 18; ++k) EXPECT_EQ(at(k)[1], 1);
  for (int k : {19, 0, 1}) EXPECT_EQ(at(k)[0], 0);
}

TEST(Border, FindsTheNearestPlaceAroundTheLoop) {
  const DiskMesh disk = make_disk(test::sheet(5, 5));
  const Border border(disk, rest_triangles(disk, 0));
  for (int k = 0; k < border.size(); ++k) {
    EXPECT_EQ(border.nearest(border.at(k)), k);
    EXPECT_EQ(border.nearest(border.at(k) + 0.4 * border.length(k) - border.total()), k);
    EXPECT_EQ(border.nearest(border.at(k) + 0.6 * border.length(k) + border.total()),
              (k + 1) % border.size());
  }
}

TEST(SharpestCorners, AreThoseOfARectangle) {
  const DiskMesh disk = make_disk(test::sheet(20, 12, 2, 1));
  EXPECT_EQ(sharpest_corners(Border(disk, rest_triangles(disk, 0))), (Corners{0, 20, 32, 52}));
}

TEST(CornersAtEars, MoveToFacesThatWouldGoFlat) {
  Mesh mesh = test::sheet(40, 40);
  // The diagonal of the first cell the other way: vertex 0 is left with one face.
  for (auto& f : mesh.faces) {
    if (f == std::array<std::int32_t, 3>{0, 1, 42}) f = {0, 1, 41};
    if (f == std::array<std::int32_t, 3>{0, 42, 41}) f = {1, 42, 41};
  }
  const DiskMesh disk = make_disk(mesh);
  ASSERT_EQ(disk.halved.size(), 1u);
  const Border border(disk, rest_triangles(disk, 0));
  EXPECT_EQ(corners_at_ears(border, {2, 40, 80, 120}), (Corners{0, 40, 80, 120}));
  EXPECT_EQ(corners_at_ears(border, {40, 80, 120, 158}), (Corners{40, 80, 120, 0}));
  EXPECT_EQ(corners_at_ears(border, {5, 40, 80, 120}), (Corners{5, 40, 80, 120}));  // too far
  EXPECT_EQ(corners_at_ears(border, {0, 1, 80, 120}), (Corners{0, 1, 80, 120}));    // there already
}

// A cost with one dip: all four corners a given way along the border.
TEST(CornerSearch, FindsADipAndKeepsItsBudget) {
  const DiskMesh disk = make_disk(test::dome(3, 240, 0.2));
  const Border border(disk, rest_triangles(disk, 0));
  const Corners dip = {13, 70, 120, 201};
  int evaluations = 0;
  const auto cost = [&](const Corners& corners) {
    ++evaluations;
    double best = 1e9;  // whichever corner is called the first
    for (int turn = 0; turn < 4; ++turn) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) {
        const double d = std::abs(border.at(corners[(k + turn) % 4]) - border.at(dip[k])) / border.total();
        sum += std::pow(std::min(d, 1 - d), 2);
      }
      best = std::min(best, sum);
    }
    return best;
  };
  const Corners found = search_corners(border, {}, cost);
  EXPECT_LT(evaluations, 400);
  EXPECT_LE(cost(found), 4 * std::pow(1.0 / 300, 2));

  evaluations = 0;
  search_corners(border, {.most_evaluations = 40}, cost);
  EXPECT_EQ(evaluations, 40);
}

TEST(Reweighting, LowersTheStretchOfABump) {
  const DiskMesh disk = make_disk(test::bump(24));
  const Elimination elimination(disk.vertex_count(), disk.edge);
  const std::vector<RestTriangle> rest = rest_triangles(disk, 0);
  const Border border(disk, rest);
  const Corners corners = sharpest_corners(border);
  const Reweighted start = reweight(disk, rest, elimination, border, corners, {.rounds = 1});
  const Reweighted end = reweight(disk, rest, elimination, border, corners, {.slide = 0.5});
  EXPECT_EQ(start.rounds, 0);
  EXPECT_GT(end.rounds, 0);
  EXPECT_LT(end.stretch.aspect_free, 0.9 * start.stretch.aspect_free);
  EXPECT_EQ(count_flipped(disk.face, end.uv), 0);
}

TEST(DiskMesh, HalvesEdgesThatCutTheBoundaryOff) {
  // A strip of triangles: every inner edge joins two boundary vertices.
  Mesh strip;
  for (int k = 0; k < 8; ++k)
    strip.vertices.insert(strip.vertices.end(), {k * 0.5, static_cast<double>(k % 2), 0});
  for (int k = 0; k < 6; ++k)
    strip.faces.push_back(k % 2 ? std::array<std::int32_t, 3>{k, k + 2, k + 1}
                                : std::array<std::int32_t, 3>{k, k + 1, k + 2});
  for (auto& f : strip.faces) std::swap(f[1], f[2]);
  const DiskMesh disk = make_disk(strip);
  EXPECT_EQ(disk.own, 8);
  EXPECT_EQ(disk.halved.size(), 5u);
  EXPECT_EQ(disk.vertex_count(), 13);
  EXPECT_EQ(disk.loop.size(), 8u);
  // An edge with both ends on the boundary is one of the boundary.
  std::vector<std::array<int, 2>> around;
  for (const int e : disk.loop_edge) around.push_back(disk.edge[e]);
  for (const auto& [a, b] : disk.edge)
    EXPECT_TRUE(!disk.on_boundary[a] || !disk.on_boundary[b] ||
                std::find(around.begin(), around.end(), std::array<int, 2>{a, b}) != around.end());
}

// A bicubic patch lies in every space of uniform knots.
TEST(TrialFit, IsExactOnACubicSheet) {
  const Mesh mesh =
      test::sheet(30, 30, 1, 1, [](double x, double y) { return x * x * x - x * y * y + 0.2 * y; });
  const DiskMesh disk = make_disk(mesh);
  std::vector<double> uv;
  for (Index k = 0; k < mesh.vertex_count(); ++k) uv.insert(uv.end(), {mesh.vertex(k)[0], mesh.vertex(k)[1]});
  const TrialFit fit = trial_fit(disk, uv);
  EXPECT_LT(fit.error, 1e-8);  // the smoothing floor
  EXPECT_LE(fit.distance, fit.error);
}

// Parameters that slide along the surface change the error, and hardly the distance.
TEST(TrialFit, DistanceForgivesSlidingAlongASurface) {
  const Mesh mesh = test::sheet(40, 40);
  const DiskMesh disk = make_disk(mesh);
  std::vector<double> uv;
  for (Index k = 0; k < mesh.vertex_count(); ++k) {
    const double x = mesh.vertex(k)[0], y = mesh.vertex(k)[1];
    uv.insert(uv.end(), {x + 0.01 * std::sin(26 * M_PI * x) * std::sin(M_PI * y), y});
  }
  for (double& x : uv) x = std::clamp(x, 0.0, 1.0);
  const TrialFit fit = trial_fit(disk, uv);
  EXPECT_GT(fit.error, 1e-3);
  EXPECT_LT(fit.distance, 1e-6);
}

}  // namespace
}  // namespace knotfit::mesh_map
