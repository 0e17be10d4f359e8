#include "knotfit/version.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>
namespace knotfit::test {
namespace {

TEST(Version, IsThreeNumbers) {
  const std::string version(knotfit::version());
  EXPECT_EQ(std::count(version.begin(), version.end(), '.'), 2) << version;
  for (char c : version) EXPECT_TRUE(c == '.' || std::isdigit(static_cast<unsigned char>(c))) << version;
  EXPECT_NE(version.front(), '.');
  EXPECT_NE(version.back(), '.');
}

}  // namespace
}  // namespace knotfit::test
