#include "report/map_content.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/map_picture.h"
#include "knotfit/parameterize_mesh.h"
#include "knotfit/threads.h"
#include "mapped_sheet.h"
#include "pixels.h"
#include "report/map_view.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

using test::expect_throw;
using test::sheet;

TEST(FaceStretches, HaveTheSquareOfTheAspectFreeStretchAsTheirMean) {
  const Mesh mesh = sheet(9, 1.7, [](double u, double v) { return 0.5 * std::sin(5 * u) * v * v; });
  const MapQuality quality = measure_map(mesh, mesh.uv);
  const std::vector<double> stretch = face_stretches(mesh, mesh.uv, quality.aspect);
  double sum = 0, total = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& t = mesh.faces[f];
    const double *a = mesh.vertex(t[0]), *b = mesh.vertex(t[1]), *c = mesh.vertex(t[2]);
    double n[3];
    for (int k = 0; k < 3; ++k)
      n[k] = (b[(k + 1) % 3] - a[(k + 1) % 3]) * (c[(k + 2) % 3] - a[(k + 2) % 3]) -
             (b[(k + 2) % 3] - a[(k + 2) % 3]) * (c[(k + 1) % 3] - a[(k + 1) % 3]);
    const double area = std::hypot(n[0], n[1], n[2]) / 2;
    sum += area * stretch[f] * stretch[f];
    total += area;
  }
  EXPECT_NEAR(std::sqrt(sum / total), quality.aspect_free_stretch, 1e-10 * quality.aspect_free_stretch);
  // A flat sheet at its own place is mapped evenly.
  const Mesh flat = sheet(5);
  for (const double s : face_stretches(flat, flat.uv, 1)) EXPECT_NEAR(s, 1, 1e-12);
  expect_throw<InvalidInput>([&] { face_stretches(flat, flat.uv, 0); }, "width over height 0");
}

}  // namespace
}  // namespace knotfit
