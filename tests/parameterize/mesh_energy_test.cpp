#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "data/orientation.h"
#include "mesh_support.h"
#include "parameterize/mesh_border.h"
#include "parameterize/mesh_mean_value.h"
#include "parameterize/mesh_newton.h"
#include "parameterize/mesh_stretch_energy.h"
namespace knotfit::mesh_map {
namespace {

std::vector<Jacobian> jacobians() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1), stretch(0.2, 3);
  std::vector<Jacobian> result{{1, 0, 0, 1}, {0, -2, 2, 0}, {3, 0, 0, 0.2}};  // equal singular values too
  while (result.size() < 60) {
    const Jacobian j{stretch(random), number(random), number(random), stretch(random)};
    if (j.determinant() > 0.05) result.push_back(j);
  }
  return result;
}

double& entry(Jacobian& j, int k) {
  double* entries[4] = {&j.xu, &j.xv, &j.yu, &j.yv};
  return *entries[k];
}

// Central differences of step h: error h^2/6 f''' and rounding eps f / h; relative 1e-6 leaves room.
TEST(StretchEnergy, GradientIsThatOfTheEnergy) {
  constexpr double h = 1e-5;
  for (const Jacobian& j : jacobians()) {
    const EnergyDerivatives d = stretch_energy_derivatives(j);
    double scale = 1;
    for (const double g : d.gradient) scale = std::max(scale, std::abs(g));
    for (int k = 0; k < 4; ++k) {
      Jacobian up = j, down = j;
      entry(up, k) += h;
      entry(down, k) -= h;
      EXPECT_NEAR(d.gradient[k], (stretch_energy(up) - stretch_energy(down)) / (2 * h), 1e-6 * scale);
    }
  }
}

TEST(StretchEnergy, HessianIsThatOfTheEnergy) {
  constexpr double h = 1e-5;
  for (const Jacobian& j : jacobians()) {
    const EnergyDerivatives d = stretch_energy_derivatives(j, kStretchTheta, false);
    double scale = 1;
    for (const auto& row : d.hessian)
      for (const double x : row) scale = std::max(scale, std::abs(x));
    for (int k = 0; k < 4; ++k) {
      Jacobian up = j, down = j;
      entry(up, k) += h;
      entry(down, k) -= h;
      const EnergyDerivatives a = stretch_energy_derivatives(up), b = stretch_energy_derivatives(down);
      for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(d.hessian[i][k], (a.gradient[i] - b.gradient[i]) / (2 * h), 1e-6 * scale);
    }
  }
}

TEST(StretchEnergy, ProjectedHessianClampsTheNegativeEigenvalues) {
  int clamped = 0;
  for (const Jacobian& j : jacobians()) {
    const EnergyDerivatives exact = stretch_energy_derivatives(j, kStretchTheta, false),
                            kept = stretch_energy_derivatives(j);
    const Eigen::Map<const Eigen::Matrix4d> a(&exact.hessian[0][0]), b(&kept.hessian[0][0]);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(a);
    const Eigen::Vector4d positive = eigen.eigenvalues().cwiseMax(0);
    const Eigen::Matrix4d expected =
        eigen.eigenvectors() * positive.asDiagonal() * eigen.eigenvectors().transpose();
    EXPECT_LE((b - expected).norm(), 1e-11 * (1 + a.norm()));
    clamped += eigen.eigenvalues()[0] < 0;
  }
  EXPECT_GT(clamped, 5);
}

TEST(StretchEnergy, IsInfiniteWhereATriangleIsFlatOrTurned) {
  EXPECT_TRUE(std::isinf(stretch_energy({1, 0, 0, 0})));
  EXPECT_TRUE(std::isinf(stretch_energy({1, 0, 0, -1})));
}

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
