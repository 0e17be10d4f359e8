#include <gtest/gtest.h>

#include "knotfit/place.h"
#include "place/trials.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(FeatureMeasures, EachDrawsTheCriterionToAStep) {
  const ParameterizedPoints points = synthetic_points("step", 5000);
  for (FeatureMeasure measure : {FeatureMeasure::curvature, FeatureMeasure::hessian,
                                 FeatureMeasure::derivative, FeatureMeasure::residual}) {
    PlacementOptions options;
    options.feature = measure;
    const InteriorKnots knots = place_knots("criterion", points, options).knots;
    EXPECT_GE(inside(knots.u, 0.15, 0.45), 4) << static_cast<int>(measure);
  }
}

}  // namespace
}  // namespace knotfit::test
