#include "solve/band_places.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>
namespace knotfit::test {
namespace {

TEST(BandPlaces, KeepNeighboursOnTheRingTogether) {
  for (int degree : {1, 2, 3, 5})
    for (int n = degree + 1; n < 24; ++n) {
      std::vector<double> period;
      for (int k = 0; k < n; ++k) period.push_back(static_cast<double>(k) / n);
      const Axis axis = Axis::periodic(degree, period);
      const BandPlaces place(axis);
      std::set<Index> places;
      for (Index s = 0; s < axis.spans(); ++s)
        for (int i = 0; i <= degree; ++i) {
          const Index a = place(axis.function(s, i));
          places.insert(a);
          for (int j = 0; j < i; ++j)
            EXPECT_LE(std::abs(a - place(axis.function(s, j))), place.bandwidth()) << degree << ", " << n;
        }
      EXPECT_EQ(places.size(), static_cast<std::size_t>(n));  // each has its own
      EXPECT_EQ(*places.begin(), 0);
      EXPECT_EQ(*places.rbegin(), n - 1);
    }
}

TEST(BandPlaces, OfAClampedAxisAreItsNumbers) {
  const Axis axis(3, std::vector<double>{0.2, 0.7});
  const BandPlaces place(axis);
  EXPECT_EQ(place.bandwidth(), 3);
  for (Index i = 0; i < axis.functions(); ++i) EXPECT_EQ(place(i), i);
}

}  // namespace
}  // namespace knotfit::test
