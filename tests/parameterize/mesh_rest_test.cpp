#include "parameterize/mesh_rest.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh_support.h"
namespace knotfit::mesh_map {
namespace {

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

}  // namespace
}  // namespace knotfit::mesh_map
