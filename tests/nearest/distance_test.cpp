#include "knotfit/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "data/meshes.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/threads.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit {
namespace {

using namespace test;

/// z = height over [0,1]^2, S_u x S_v upwards.
Surface level(double height, int spans = 3) {
  const KnotVector knots = KnotVector::uniform(3, spans - 1);
  std::vector<double> net;
  for (const double x : knots.greville())
    for (const double y : knots.greville()) net.insert(net.end(), {x, y, height});
  return Surface(knots, knots, 3, net);
}

Mesh flat_sheet(int cells) {
  Mesh mesh = sheet(cells, cells);
  for (Index k = 0; k < mesh.vertex_count(); ++k) mesh.vertices[3 * k + 2] = 0;
  return mesh;
}

std::vector<double> places_of(const Mesh& mesh) {
  std::vector<double> uv;
  for (Index k = 0; k < mesh.vertex_count(); ++k) uv.insert(uv.end(), {mesh.vertex(k)[0], mesh.vertex(k)[1]});
  return uv;
}

TEST(PointDistances, AreSignedByTheNormal) {
  const std::vector<double> points{0.2, 0.3, 1.5, 0.5, 0.5, 0.9, 0.7, 0.1, 1.0, 0.1, 0.9, 1.2};
  const PointDistances d = point_distances(level(1), points);
  const double expected[] = {0.5, -0.1, 0, 0.2};
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(d.signed_distances[k], expected[k], 1e-12);
  EXPECT_EQ(d.summary.count, 4);
  EXPECT_NEAR(d.summary.rms, std::sqrt((0.25 + 0.01 + 0.04) / 4), 1e-12);
  EXPECT_NEAR(d.summary.max, 0.5, 1e-12);
  EXPECT_NEAR(d.summary.mean, 0.2, 1e-12);
  EXPECT_NEAR(d.summary.signed_mean, 0.15, 1e-12);
  EXPECT_NEAR(d.summary.median, 0.1, 1e-12);
  EXPECT_NEAR(d.summary.p95, 0.5, 1e-12);
  // sum of squares over n less the square of the mean
  EXPECT_NEAR(d.summary.deviation, std::sqrt(0.3 / 4 - 0.15 * 0.15), 1e-12);
  EXPECT_EQ(d.summary.worst, 0);
  EXPECT_NEAR(d.summary.worst_u, 0.2, 1e-9);
  EXPECT_EQ(d.summary.worst_point[2], 1.5);
  EXPECT_EQ(share_within(d, 0.25), 0.75);
  EXPECT_EQ(share_within(d, 0), d.signed_distances[2] == 0 ? 0.25 : 0.0);
}

TEST(PointDistances, TakeTheDatasNormalsWhereGiven) {
  const std::vector<double> points{0.2, 0.3, 1.5, 0.5, 0.5, 0.9}, normals{0, 0, -1, 0, 0, -1};
  const PointDistances d = point_distances(level(1), points, {}, normals);
  EXPECT_NEAR(d.signed_distances[0], -0.5, 1e-12);
  EXPECT_NEAR(d.signed_distances[1], 0.1, 1e-12);
}

TEST(MeshDistances, OfParallelPlanesAreTheirDistance) {
  const DistanceSummary d = mesh_distances(level(0.25), flat_sheet(9), {}, 30);
  EXPECT_EQ(d.count, 900);
  EXPECT_NEAR(d.rms, 0.25, 1e-12);
  EXPECT_NEAR(d.max, 0.25, 1e-12);
  EXPECT_NEAR(d.deviation, 0, 1e-12);
}

TEST(MeshDistances, SeeAWaveThatNoVertexSees) {
  // Zero with its control points at every third place of a line lifted: a ridge between the vertices.
  const KnotVector knots = KnotVector::uniform(3, 29);
  std::vector<double> net;
  const std::vector<double> g = knots.greville();
  for (std::size_t i = 0; i < g.size(); ++i)
    for (const double y : g) net.insert(net.end(), {g[i], y, i == 17 ? 0.3 : 0});
  const Surface wave(knots, knots, 3, net);
  const Mesh mesh = flat_sheet(5);
  EXPECT_LT(point_distances(wave, mesh.vertices).summary.max, 1e-12);
  EXPECT_NEAR(mesh_distances(wave, mesh).max, 0.3 * 2 / 3, 1e-3);  // B of a uniform cubic at its middle
}

TEST(MeshDistances, SeeABeakAtTheBorderAndAtACorner) {
  const KnotVector knots = KnotVector::uniform(3, 29);
  const std::vector<double> g = knots.greville();
  const auto lifted = [&](std::size_t row, std::size_t column) {
    std::vector<double> net;
    for (std::size_t i = 0; i < g.size(); ++i)
      for (std::size_t j = 0; j < g.size(); ++j)
        net.insert(net.end(), {g[i], g[j], i == row && j == column ? 0.3 : 0});
    return Surface(knots, knots, 3, net);
  };
  const Mesh mesh = flat_sheet(5);
  // The first row of control points is the border curve; the first samples inside stand at 7/8 of the span, (7/8)^3 as high.
  for (const int samples : {10, 300}) {
    const DistanceSummary border = mesh_distances(lifted(0, 17), mesh, {}, samples);
    EXPECT_NEAR(border.max, 0.3 * 2 / 3, 0.01 * 0.2);
    EXPECT_EQ(border.worst_u, 0);
    EXPECT_NEAR(border.worst_v, g[17], 2e-3);
    EXPECT_NEAR(border.worst_point[2], border.max, 1e-12);
    const DistanceSummary corner = mesh_distances(lifted(g.size() - 1, 0), mesh, {}, samples);
    EXPECT_NEAR(corner.max, 0.3, 1e-12);
    EXPECT_EQ(corner.worst_u, 1);
    EXPECT_EQ(corner.worst_v, 0);
  }
}

/// A knot as often as the degree, or once more: a crease, or two pieces; cusps there are narrower than samples show.
bool jumps(const KnotVector& knots) {
  const std::vector<double> interior = knots.interior();
  for (const double x : interior)
    if (std::count(interior.begin(), interior.end(), x) >= knots.degree()) return true;
  return false;
}

TEST(MeshDistances, TheLargestIsKnownToAHundredthFromFewSamplesAsFromMany) {
  Random random;
  for (int trial = 0; trial < 8; ++trial) {
    const Surface s = random_surface(random, 3, Ends::clamped, 3);
    const Mesh mesh = sheet(20, 20);
    if (jumps(s.knots_u()) || jumps(s.knots_v())) continue;
    const double few = mesh_distances(s, mesh, {}, 40).max, many = mesh_distances(s, mesh, {}, 400).max;
    // A place taken by chance may lie higher, but not by more than what was asked for.
    EXPECT_NEAR(few, many, 0.01 * many) << "trial " << trial;
  }
}

TEST(MeshDistances, LeaveHolesOutWhereTheMapIsGiven) {
  Mesh mesh = flat_sheet(10);
  const std::vector<double> uv = places_of(mesh);
  const Surface s = level(0);
  std::vector<std::array<std::int32_t, 3>> kept;
  for (const auto& f : mesh.faces) {  // nothing for x > 0.5
    double x = 0;
    for (const std::int32_t k : f) x += mesh.vertex(k)[0] / 3;
    if (x < 0.5) kept.push_back(f);
  }
  Mesh half = mesh;
  half.faces = kept;
  EXPECT_NEAR(mesh_distances(s, half, {}, 100).max, 0.5, 0.011);
  const DistanceSummary with = mesh_distances(s, half, uv, 100);
  EXPECT_NEAR(with.max, 0, 1e-12);
  EXPECT_NEAR(static_cast<double>(with.count), 100 * 99 / 2.0, 100);
  // The same by virtual faces.
  mesh.virtual_face.assign(mesh.faces.size(), 0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    mesh.virtual_face[f] = std::find(kept.begin(), kept.end(), mesh.faces[f]) == kept.end();
  EXPECT_EQ(mesh_distances(s, mesh, uv, 100).count, with.count);
  EXPECT_NEAR(mesh_distances(s, mesh, {}, 100).max, 0.5, 0.011);
}

TEST(MeshDistances, SameBitsForOneAndTwoThreads) {
  Random random;
  const Surface s = random_surface(random, 3, Ends::clamped, 3);
  const Mesh mesh = sheet(20, 20);
  DistanceSummary d[2];
  for (const int threads : {1, 2}) {
    set_thread_count(threads);
    d[threads - 1] = mesh_distances(s, mesh, {}, 60);
  }
  set_thread_count(0);
  EXPECT_EQ(d[0].rms, d[1].rms);
  EXPECT_EQ(d[0].max, d[1].max);
  EXPECT_EQ(d[0].worst, d[1].worst);
}

TEST(MeshDistances, StopWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  Control control;
  control.stop = stop.get_token();
  EXPECT_EQ(mesh_distances(level(0), flat_sheet(3), {}, 50, control).count, 0);
  EXPECT_TRUE(point_distances(level(0), std::vector<double>(3 * 20000, 0.5), {}, {}, control).stopped);
}

TEST(Distances, RefuseWhatHasNone) {
  const Surface s = level(0);
  const Mesh mesh = flat_sheet(3);
  Mesh none;
  none.vertices = mesh.vertices;
  expect_throw<InvalidInput>([&] { point_distances(s, {}); }, "no points");
  expect_throw<InvalidInput>(
      [&] {
        point_distances(s, std::vector<double>{0, 0, 0}, {}, std::vector<double>{1});
      },
      "1 numbers for normals");
  expect_throw<InvalidInput>([&] { mesh_distances(Surface(), mesh); }, "surfaces in space");
  expect_throw<InvalidInput>([&] { mesh_distances(s, none); }, "no faces");
  expect_throw<InvalidInput>([&] { mesh_distances(s, mesh, {}, 0); }, "0 samples");
  expect_throw<InvalidInput>([&] { mesh_distances(s, mesh, std::vector<double>{1}); }, "16 vertices need 32");
  Mesh holes = mesh;
  holes.virtual_face.assign(holes.faces.size(), 1);
  expect_throw<InvalidInput>([&] { mesh_distances(s, holes); }, "only closes a hole");
  std::vector<double> away = places_of(mesh);
  for (double& x : away) x += 5;
  expect_throw<InvalidInput>([&] { mesh_distances(s, mesh, away); }, "covers no part");
}

}  // namespace
}  // namespace knotfit
