#include "data/parameter_groups.h"

#include <gtest/gtest.h>

#include <vector>

namespace knotfit {
namespace {

TEST(ParameterGroups, AreInTheOrderOfTheParametersWithEqualOnesTogether) {
  const std::vector<double> t = {0.5, 0.25, 0.5, 1, 0.25, 0.5};
  const ParameterGroups groups = group_by_parameter(t);
  EXPECT_EQ(groups.order, (std::vector<Index>{1, 4, 0, 2, 5, 3}));
  EXPECT_EQ(groups.start, (std::vector<Index>{0, 2, 5, 6}));
  ASSERT_EQ(groups.size(), 3);
  const auto middle = groups.group(1);
  EXPECT_EQ(std::vector<Index>(middle.begin(), middle.end()), (std::vector<Index>{0, 2, 5}));
}

TEST(ParameterGroups, OfNoPointsAreNone) {
  EXPECT_EQ(group_by_parameter({}).size(), 0);
  EXPECT_EQ(group_by_parameter(std::vector{0.3}).size(), 1);
}

}  // namespace
}  // namespace knotfit
