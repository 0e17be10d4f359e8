#include <gtest/gtest.h>

#include <string_view>

#include "knotfit/refine.h"

namespace knotfit {
namespace {

TEST(Status, HasTheNamesThatReportsAndScriptsRead) {
  EXPECT_EQ(to_string(Status::not_run), "not_run");
  EXPECT_EQ(to_string(Status::fixed_size), "fixed_size");
  EXPECT_EQ(to_string(Status::reached), "reached");
  EXPECT_EQ(to_string(Status::not_reached), "not_reached");
  EXPECT_EQ(to_string(Status::data_too_sparse), "data_too_sparse");
  EXPECT_EQ(to_string(Status::tolerance_below_noise), "tolerance_below_noise");
  EXPECT_EQ(to_string(Status::swings), "swings");
  EXPECT_EQ(to_string(Status::folded), "folded");
  EXPECT_EQ(to_string(Status::limit_reached), "limit_reached");
  EXPECT_EQ(to_string(Status::time_limit), "time_limit");
  EXPECT_EQ(to_string(Status::stopped), "stopped");
  EXPECT_EQ(to_string(Status::failed), "failed");
}

}  // namespace
}  // namespace knotfit
