#include <gtest/gtest.h>

#include <utility>

#include "knotfit/place.h"
#include "place/shares.h"
#include "place/trials.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(ConjugateGradient, LowersTheErrorFromUniform) {
  for (const char* name : {"franke", "ridge"}) {
    const ParameterizedPoints points = synthetic_points(name, 3000);
    EXPECT_LT(rms(points, place_knots("conjugate-gradient", points).knots),
              0.95 * rms(points, {uniform_knots(8), uniform_knots(8)}))
        << name;
  }
}

TEST(ConjugateGradient, IsNeverWorseThanItsStart) {
  for (const std::string& name : synthetic_names()) {
    const ParameterizedPoints points = synthetic_points(name, 1000);
    for (const auto& [u, v] : {std::pair{1, 0}, std::pair{4, 3}, std::pair{9, 9}}) {
      PlacementOptions options;
      options.interior_u = u;
      options.interior_v = v;
      EXPECT_LE(rms(points, place_knots("conjugate-gradient", points, options).knots),
                rms(points, {uniform_knots(u), uniform_knots(v)}) * (1 + 1e-9))
          << name << " " << u << " x " << v;
    }
  }
}

}  // namespace
}  // namespace knotfit::test
