#include "nearest/map_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "data/mesh_data.h"
#include "data/meshes.h"
#include "knotfit/threads.h"
#include "support/random_splines.h"
namespace knotfit {
namespace {

using namespace test;

TEST(MapSamples, FindTheTriangleOfEveryPlace) {
  Random random;
  const Mesh mesh = sheet(7, 7);
  const std::vector<Vec3> vertices = vertex_places(mesh);
  std::vector<double> uv;
  for (const Vec3& p : vertices)
    for (const double x : {p.x, p.y}) uv.push_back(x > 0 && x < 1 ? x + random.uniform(-0.02, 0.02) : x);
  const MapView map{vertices, mesh.faces, {}, uv};
  std::vector<double> u{0, 1}, v{0, 1};
  for (int k = 0; k < 50; ++k) u.push_back(random.unit()), v.push_back(random.unit());
  std::sort(u.begin(), u.end());
  std::sort(v.begin(), v.end());
  MapSamples first;
  for (const int threads : {1, 2}) {
    set_thread_count(threads);
    const MapSamples s = sample_map(map, u, v);
    if (threads == 1) first = s;
    EXPECT_EQ(s.face, first.face);
  }
  set_thread_count(0);
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) {
      std::int32_t expected = -1;
      for (std::size_t f = 0; f < map.faces.size() && expected < 0; ++f) {
        const auto& t = map.faces[f];
        bool inside = true;
        for (int k = 0; k < 3; ++k) {
          const double *a = &uv[2 * t[k]], *b = &uv[2 * t[(k + 1) % 3]];
          inside = inside && (b[0] - a[0]) * (v[j] - a[1]) - (b[1] - a[1]) * (u[i] - a[0]) >= -1e-14;
        }
        if (inside) expected = static_cast<std::int32_t>(f);
      }
      EXPECT_EQ(first.face[first.index(i, j)], expected);
    }
}

TEST(MapSamples, WindowMeansAreThoseOfTheirSamples) {
  Random random;
  const Index nu = 13, nv = 9, reach = 2;
  std::vector<double> x = random_numbers(random, nu * nv * 2);
  std::vector<char> use;
  for (Index k = 0; k < nu * nv; ++k) use.push_back(random.integer(0, 3) > 0 || k < 2);
  const std::vector<double> means = window_means(x, 2, use, nu, nv, reach);
  for (Index i = 0; i < nu; ++i)
    for (Index j = 0; j < nv; ++j)
      for (int c = 0; c < 2; ++c) {
        double sum = 0, count = 0;
        for (Index a = 0; a < nu; ++a)
          for (Index b = 0; b < nv; ++b)
            if (std::abs(a - i) <= reach && std::abs(b - j) <= reach && use[a * nv + b])
              sum += x[(a * nv + b) * 2 + c], count += 1;
        EXPECT_NEAR(means[(i * nv + j) * 2 + c], count > 0 ? sum / count : 0, 1e-14);
      }
}

TEST(MapSamples, DerivativesOfATriangleAreThoseOfItsPlane) {
  const std::vector<Vec3> vertices{{1, 2, 3}, {4, 0, 1}, {2, 2, 5}};
  const std::vector<std::array<std::int32_t, 3>> faces{{0, 1, 2}};
  const std::vector<double> uv{0.1, 0.2, 0.7, 0.3, 0.2, 0.9};
  const TriangleFrame f = triangle_frame({vertices, faces, {}, uv}, 0);
  for (const int k : {1, 2}) {
    const Vec3 step = (uv[2 * k] - uv[0]) * f.xu + (uv[2 * k + 1] - uv[1]) * f.xv;
    EXPECT_NEAR(length(step - (vertices[k] - vertices[0])), 0, 1e-13);
    EXPECT_NEAR(dot(f.normal, vertices[k] - vertices[0]), 0, 1e-13);
  }
}

}  // namespace
}  // namespace knotfit
