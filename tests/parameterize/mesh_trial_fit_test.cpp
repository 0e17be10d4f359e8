#include "parameterize/mesh_trial_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh_support.h"
namespace knotfit::mesh_map {
namespace {

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
