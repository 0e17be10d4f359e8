#include "parameterize/mesh_newton.h"

#include <gtest/gtest.h>

#include <cmath>

#include "data/orientation.h"
#include "mesh_support.h"
#include "parameterize/mesh_border.h"
#include "parameterize/mesh_mean_value.h"
#include "parameterize/mesh_stretch_energy.h"
namespace knotfit::mesh_map {
namespace {

std::vector<double> mean_value_start(const DiskMesh& disk, const std::vector<RestTriangle>& rest,
                                     const Elimination& elimination) {
  const Border border(disk, rest);
  std::vector<double> uv(2 * disk.position.size());
  ConvexMap map(disk, elimination);
  EXPECT_TRUE(map.factor(mean_value_weights(disk, rest)));
  border.place(sharpest_corners(border), uv);
  map.solve(uv);
  return uv;
}

TEST(NewtonMap, BringsTheEnergyDownAndTurnsNothingOver) {
  const DiskMesh disk = make_disk(test::bump(24));
  const Elimination elimination(disk.vertex_count(), disk.edge);
  for (const double omega : {0.0, 0.1}) {
    const std::vector<RestTriangle> rest = rest_triangles(disk, omega);
    NewtonMap map(disk, rest, elimination, mean_value_start(disk, rest, elimination));
    double before = map.energy();
    for (int round = 0; round < 30 && !map.converged(); ++round) {
      map.advance(1);
      EXPECT_LE(map.energy(), before);
      before = map.energy();
      EXPECT_EQ(count_flipped(disk.face, map.square_parameters()), 0);
    }
    EXPECT_TRUE(map.converged());
  }
}

// At the optimum no small move of a vertex along its free coordinates helps. Rounds end where the energy
// falls by d = 1e-14 of itself, which leaves a gradient of some sqrt(2 d times the curvature, up to 1e3).
TEST(NewtonMap, EndsWhereNoVertexCanHelp) {
  const DiskMesh disk = make_disk(test::bump(10));
  const Elimination elimination(disk.vertex_count(), disk.edge);
  const std::vector<RestTriangle> rest = rest_triangles(disk, 0.05);
  NewtonMap map(disk, rest, elimination, mean_value_start(disk, rest, elimination));
  map.advance(200, 1e-14);
  const std::vector<double> uv = map.square_parameters();
  const std::vector<char> fixed = fixed_coordinates(disk, uv);
  const double aspect = map.aspect();
  double area = 0;
  for (const RestTriangle& r : rest) area += r.area;
  const auto energy = [&](std::vector<double> p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); i += 2)
      p[i] *= std::sqrt(area * aspect), p[i + 1] *= std::sqrt(area / aspect);
    for (int f = 0; f < disk.face_count(); ++f)
      sum += rest[f].area * stretch_energy(jacobian(rest[f], disk.face[f], p.data()));
    return sum / area;
  };
  constexpr double h = 1e-6;
  for (std::size_t i = 0; i < uv.size(); ++i) {
    if (fixed[i / 2] >> (i % 2) & 1) continue;
    std::vector<double> up = uv, down = uv;
    up[i] += h;
    down[i] -= h;
    EXPECT_NEAR((energy(up) - energy(down)) / (2 * h), 0, 1e-5) << "coordinate " << i;
  }
}

TEST(NewtonMap, FindsTheRectangleOfAFlatSheet) {
  const DiskMesh disk = make_disk(test::sheet(12, 6, 3, 1, {}, 0.3));
  const Elimination elimination(disk.vertex_count(), disk.edge);
  const std::vector<RestTriangle> rest = rest_triangles(disk, 0);
  std::vector<double> start = mean_value_start(disk, rest, elimination);
  for (const int i : disk.loop)  // slid along the sides
    for (int c = 0; c < 2; ++c)
      start[2 * i + c] +=
          0.1 * std::sin(2 * M_PI * start[2 * i + c]) * (start[2 * i + c] > 0 && start[2 * i + c] < 1);
  NewtonMap map(disk, rest, elimination, start);
  map.advance(60, 1e-15);
  const std::vector<double> uv = map.square_parameters();
  const Stretch stretch = measure_stretch(disk, rest, uv);
  EXPECT_NEAR(stretch.aspect_free, 1, 1e-9);
  const double aspect = std::max(stretch.aspect, 1 / stretch.aspect);
  EXPECT_NEAR(aspect, 3, 1e-4);
}

}  // namespace
}  // namespace knotfit::mesh_map
