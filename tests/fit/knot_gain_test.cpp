#include "fit/knot_gain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fit/moving_fit.h"
#include "solve/banded_system.h"
#include "support/plain_fits.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(KnotGain, RanksSpansAsFitsWithTheKnotDo) {
  // The gain looks at one function at a time, so it bounds nothing; but the span that a knot helps most must
  // be among its first.
  const ParameterizedPoints points = synthetic_points("franke", 4000);
  MovingFit problem(points, 3, 3, plain_fits());
  const InteriorKnots knots{{0.2, 0.4, 0.6, 0.8}, {0.25, 0.5, 0.75}};
  for (bool along_v : {false, true}) {
    problem.solve(knots);
    const std::vector<double> gain = knot_gains(problem, along_v);
    const auto& line = along_v ? knots.v : knots.u;
    ASSERT_EQ(gain.size(), line.size() + 1);
    std::vector<double> after;
    for (std::size_t s = 0; s < gain.size(); ++s) {
      InteriorKnots with = knots;
      auto& k = along_v ? with.v : with.u;
      const double low = s > 0 ? line[s - 1] : 0, high = s < line.size() ? line[s] : 1;
      k.insert(k.begin() + static_cast<Index>(s), (low + high) / 2);
      problem.solve(with);
      after.push_back(problem.phi());
    }
    const auto best = std::min_element(after.begin(), after.end()) - after.begin();
    const auto better = std::count_if(gain.begin(), gain.end(), [&](double g) { return g > gain[best]; });
    EXPECT_LE(better, 1);
  }
}

}  // namespace
}  // namespace knotfit::test
