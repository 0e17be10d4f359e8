#include <gtest/gtest.h>

#include <set>

#include "knotfit/parameterize_mesh.h"
#include "mesh_support.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

using test::expect_throw;

TEST(ParameterLines, RunAcrossAFlatSheet) {
  const Mesh mesh = test::sheet(7, 5, 2, 1, {}, 0.3);
  std::vector<double> uv;
  for (Index k = 0; k < mesh.vertex_count(); ++k)
    uv.insert(uv.end(), {mesh.vertex(k)[0] / 2, mesh.vertex(k)[1]});
  const auto lines = parameter_lines(mesh, uv, 4);
  ASSERT_EQ(lines.size(), 10u);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const int axis = k < 5 ? 0 : 1;
    const double value = (axis == 0 ? 2 : 1) * static_cast<double>(k % 5) / 4;
    ASSERT_GE(lines[k].size(), 2u);
    for (const auto& p : lines[k]) EXPECT_NEAR(p[axis], value, 1e-14);
    EXPECT_EQ(lines[k].front()[1 - axis], 0);
    EXPECT_NEAR(lines[k].back()[1 - axis], axis == 0 ? 1 : 2, 1e-14);
    for (std::size_t i = 1; i < lines[k].size(); ++i)
      EXPECT_GE(lines[k][i][1 - axis], lines[k][i - 1][1 - axis]);
  }
}

}  // namespace
}  // namespace knotfit
