#include <gtest/gtest.h>

#include <algorithm>

#include "knotfit/exceptions.h"
#include "knotfit/place.h"
#include "place/shares.h"
#include "place/trials.h"
#include "support/expect_throw.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(Evolutionary, KeepsToItsBudgetAndRepeats) {
  const ParameterizedPoints points = synthetic_points("ridge", 1000);
  for (const PlacementMethod& method : placement_methods()) {
    if (!method.name.starts_with("evolutionary")) continue;
    PlacementOptions options;
    options.interior_u = options.interior_v = 4;
    options.evaluations = 400;
    const Placement one = place_knots(method.name, points, options),
                    two = place_knots(method.name, points, options);
    EXPECT_EQ(one.knots, two.knots) << method.name;
    EXPECT_LE(one.fits, 400) << method.name;
    EXPECT_GE(one.fits, 300) << method.name;
    EXPECT_EQ(one.status, PlacementStatus::limit);
    EXPECT_LE(rms(points, one.knots), rms(points, {uniform_knots(4), uniform_knots(4)})) << method.name;
    options.evaluations = 4000;
    EXPECT_LE(rms(points, place_knots(method.name, points, options).knots),
              rms(points, one.knots) * (1 + 1e-9))
        << method.name;
  }
}

TEST(Evolutionary, WithoutNloptIsSaidSo) {
  const ParameterizedPoints points = synthetic_points("franke", 200);
  const auto methods = placement_methods();
  const bool there = std::any_of(methods.begin(), methods.end(),
                                 [](const PlacementMethod& m) { return m.name == "evolutionary"; });
  if (there) GTEST_SKIP() << "built with NLopt";
  expect_throw<InvalidInput>([&] { place_knots("evolutionary", points); }, "built without NLopt");
}

}  // namespace
}  // namespace knotfit::test
