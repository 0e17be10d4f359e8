#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize_mesh.h"
#include "mesh_support.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

using test::expect_throw;

TEST(MeasureMap, KnowsAffineMapsAndFlips) {
  const Mesh mesh = test::sheet(6, 6);
  std::vector<double> uv;
  for (Index k = 0; k < mesh.vertex_count(); ++k) uv.insert(uv.end(), {mesh.vertex(k)[0], mesh.vertex(k)[1]});
  const MapQuality identity = measure_map(mesh, uv);
  EXPECT_NEAR(identity.stretch, 1, 1e-12);
  EXPECT_NEAR(identity.aspect, 1, 1e-12);
  EXPECT_NEAR(identity.worst_angle, 90, 1e-9);
  EXPECT_EQ(identity.flipped, 0);
  std::vector<double> sheared = uv;  // singular values of [1 1; 0 1] on its best rectangle, width sqrt(1/2)
  for (std::size_t k = 0; k < uv.size(); k += 2) sheared[k] += uv[k + 1];
  const double a = std::sqrt(0.5), norm = 2 * a * a + 1, root = std::sqrt(norm * norm - 4 * a * a);
  EXPECT_NEAR(measure_map(mesh, sheared).worst_angle,
              2 * std::atan(std::sqrt((norm - root) / (norm + root))) * 180 / M_PI, 1e-9);
  std::vector<double> mirrored = uv;
  for (std::size_t k = 0; k < uv.size(); k += 2) mirrored[k] = 1 - uv[k];
  EXPECT_EQ(measure_map(mesh, mirrored).flipped, mesh.face_count());
}

TEST(MeasureMap, NamesBadParameters) {
  const Mesh mesh = test::sheet(2, 2);
  std::vector<double> uv(18, 0.5);
  uv[7] = INFINITY;
  expect_throw<InvalidInput>([&] { measure_map(mesh, uv); }, "vertex 3: v = inf is not finite");
  uv.pop_back();
  expect_throw<InvalidInput>([&] { measure_map(mesh, uv); },
                             "9 vertices need 18 parameters, u and v each; there are 17");
  expect_throw<InvalidInput>([&] { mesh_points(mesh, uv); }, "there are 17");
  expect_throw<InvalidInput>([&] { parameter_lines(mesh, uv, 3); }, "there are 17");
  expect_throw<InvalidInput>([&] { measure_map({}, {}); }, "no faces");
  expect_throw<InvalidInput>(
      [&] {
        halve_edges(mesh, {{0, 8}});
      },
      "no face has an edge from vertex 0 to vertex 8");
}

}  // namespace
}  // namespace knotfit
