#include "parameterize/mesh_stretch_energy.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "mesh_support.h"
#include "parameterize/mesh_border.h"
#include "parameterize/mesh_mean_value.h"
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

}  // namespace
}  // namespace knotfit::mesh_map
