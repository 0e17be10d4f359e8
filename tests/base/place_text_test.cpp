#include "base/place_text.h"

#include <gtest/gtest.h>
namespace knotfit::test {
namespace {

TEST(PlaceText, FindsAPlaceOfAMapProjection) {
  EXPECT_EQ(place_text(5806023.25), "5806023.25");
  EXPECT_EQ(place_text(371047.8512), "371047.8512");
  EXPECT_EQ(place_text(-84.413333333333), "-84.4133333333");
  EXPECT_EQ(place_text(5806023250.0), "5806023250");
}

TEST(PlaceText, ShowsNoRounding) {
  EXPECT_EQ(place_text(0.1 + 0.2), "0.3");
  EXPECT_EQ(place_text(5806023.25 + 1e-9), "5806023.25");
  EXPECT_EQ(place_text(0), "0");
  EXPECT_EQ(place_text(1e-7), "1e-07");
}

}  // namespace
}  // namespace knotfit::test
