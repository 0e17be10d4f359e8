#include "knotfit/features.h"

#include <gtest/gtest.h>

#include <limits>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

TEST(FeatureMaps, AreValidatedByShapeAndValue) {
  validate(FeatureMap{2, 2, {0, 1, 2, 3}});
  for (const FeatureMap& bad : {FeatureMap{}, FeatureMap{2, 2, {1}}, FeatureMap{-1, -1, {1}}})
    expect_throw<InvalidInput>([&] { validate(bad); }, "a feature map of");
  for (double bad :
       {-1e-300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    expect_throw<InvalidInput>(
        [&] {
          validate(FeatureMap{2, 3, {0, 1, 2, 3, 4, bad}});
        },
        "the feature measure of cell (1, 2) is");
}

}  // namespace
}  // namespace knotfit::test
