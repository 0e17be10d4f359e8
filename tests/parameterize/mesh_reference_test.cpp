// The local reference of verify/ on maps of scans, held against the mesh itself: error bars must be honest where
// the parameters crowd.
#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/parameterize_mesh.h"
#include "mesh_support.h"
#include "support/synthetic.h"
#include "verify/reference_field.h"
namespace knotfit {
namespace {

// The point of the mesh at (u, v); false between its triangles.
bool on_mesh(const Mesh& mesh, const std::vector<double>& uv, double u, double v, double* point) {
  for (const auto& t : mesh.faces) {
    const double *a = &uv[2 * t[0]], *b = &uv[2 * t[1]], *c = &uv[2 * t[2]];
    const double whole = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    const double second = ((u - a[0]) * (c[1] - a[1]) - (v - a[1]) * (c[0] - a[0])) / whole;
    const double third = ((b[0] - a[0]) * (v - a[1]) - (b[1] - a[1]) * (u - a[0])) / whole;
    if (second < -1e-12 || third < -1e-12 || second + third > 1 + 1e-12) continue;
    for (int d = 0; d < 3; ++d)
      point[d] = (1 - second - third) * mesh.vertex(t[0])[d] + second * mesh.vertex(t[1])[d] +
                 third * mesh.vertex(t[2])[d];
    return true;
  }
  return false;
}

class MeshReference : public ::testing::TestWithParam<const char*> {};

TEST_P(MeshReference, IsNearTheMeshWhereItPromises) {
  if (!std::getenv("KNOTFIT_DATA")) GTEST_SKIP() << "KNOTFIT_DATA is not set";
  const Mesh mesh = test::read_mesh(GetParam());
  const MeshMap map = parameterize_mesh(mesh, {.corners = CornerRule::sharpest, .omega = 0.05});
  const ParameterizedPoints points = mesh_points(mesh, map.uv);
  const double diagonal = test::synthetic_diagonal(points), tolerance = 0.01 * diagonal;
  const verify::ReferenceField field(points, tolerance, {}, {}, 1);
  test::Uniform random(3);
  std::vector<verify::Place> places(1500);
  for (verify::Place& p : places) p = {random(), random()};
  const std::vector<verify::ReferenceValue> found = field.at(places);
  int promised = 0, beyond = 0;
  double worst = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const verify::ReferenceValue& r = found[k];
    double p[3];
    if (!(r.error_bar <= tolerance / 2 && r.gap <= verify::kHole)) continue;
    if (!on_mesh(mesh, map.uv, places[k][0], places[k][1], p)) continue;
    const double off = std::hypot(r.value[0] - p[0], r.value[1] - p[1], r.value[2] - p[2]) / diagonal;
    ++promised;
    worst = std::max(worst, off);
    // The facets themselves are about 1e-3 off any smooth surface.
    beyond += off > 3 * r.error_bar / diagonal + 1e-3;
  }
  EXPECT_GT(promised, 1000);
  EXPECT_LT(worst, 0.03);  // 19 diagonals before error bars had a floor
  EXPECT_LT(beyond, 0.04 * promised);
}

INSTANTIATE_TEST_SUITE_P(Scans, MeshReference,
                         ::testing::Values("face.obj", "mask.obj", "skull_top.ply", "cowhead.obj"),
                         [](const auto& scan) {
                           std::string name = scan.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace knotfit
