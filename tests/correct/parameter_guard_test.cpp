#include "correct/parameter_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "correct/flat_mesh.h"
#include "data/orientation.h"
#include "support/random_splines.h"
namespace knotfit::correction {
namespace {

using namespace knotfit::test;

TEST(ParameterGuard, KeepsEveryTriangle) {
  Random random;
  const HoldingMesh m = flat(12);
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::vector<double> to = m.uv;
    for (double& x : to) x = std::clamp(x + random.uniform(-0.2, 0.2), 0.0, 1.0);
    ParameterGuard guard(m.face, m.size());
    const Index held = guard.hold(m.uv, to);
    EXPECT_GT(held, 0);
    const auto least = [&] {
      double a = INFINITY;
      for (const auto& t : m.face) a = std::min(a, twice_area(to, t));
      return a;
    };
    EXPECT_GE(least(), 0.02 / 144 * (1 - 1e-9));
    const std::vector<double> before = to;
    guard.relax(to, std::vector<Slide>(static_cast<std::size_t>(m.size()), Slide::free), 2);
    EXPECT_GT(least(), 0);
    EXPECT_NE(before, to);
  }
}

TEST(ParameterGuard, LetsGoodMovesBe) {
  const HoldingMesh m = flat(6);
  std::vector<double> to = m.uv;
  for (std::size_t k = 0; k < to.size(); ++k) to[k] = to[k] * to[k];
  const std::vector<double> wanted = to;
  EXPECT_EQ(ParameterGuard(m.face, m.size()).hold(m.uv, to), 0);
  EXPECT_EQ(to, wanted);
}

}  // namespace
}  // namespace knotfit::correction
