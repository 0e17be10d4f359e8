#include "search/noise_plateau.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "knotfit/refine.h"
namespace knotfit::test {
namespace {

/// RMS of n control points on white noise: they take their share n / N of its squares.
double white(double noise, double points, double n) {
  return noise * std::sqrt((points - n) / points);
}

TEST(NoisePlateau, IsSeenAfterTwoSizesThatOnlyFollowTheNoise) {
  NoisePlateau plateau(0.1, 1000, 1);
  EXPECT_FALSE(plateau.add(50, white(0.1, 1000, 50)));
  EXPECT_FALSE(plateau.add(80, white(0.1, 1000, 80)));
  EXPECT_TRUE(plateau.add(120, white(0.1, 1000, 120)));
}

TEST(NoisePlateau, GrowsWithTheDimension) {
  const double rms = 0.1 * std::sqrt(3.0);
  NoisePlateau plateau(0.1, 1000, 3);
  EXPECT_FALSE(plateau.add(50, white(rms, 1000, 50)));
  EXPECT_FALSE(plateau.add(80, white(rms, 1000, 80)));
  EXPECT_TRUE(plateau.add(120, white(rms, 1000, 120)));
}

TEST(NoisePlateau, IsNotSeenWhileTheErrorFalls) {
  NoisePlateau plateau(0.1, 1000, 1);
  double rms = 0.14;
  for (Index n : {50, 80, 120, 200, 300}) {
    EXPECT_FALSE(plateau.add(n, rms));
    rms *= 0.8;
  }
}

TEST(NoisePlateau, IsNotSeenFarAboveTheNoise) {
  // A flat stretch before a step is resolved: RMS ten times the noise.
  NoisePlateau plateau(0.1, 1000, 1);
  for (Index n : {50, 80, 120, 200, 300})
    EXPECT_FALSE(plateau.add(n, white(1, 1000, static_cast<double>(n))));
}

TEST(NoisePlateau, IsNeverSeenWithoutNoise) {
  NoisePlateau plateau(0, 1000, 1);
  for (Index n : {50, 80, 120, 200, 300}) EXPECT_FALSE(plateau.add(n, 1e-9));
}

TEST(NoisePlateau, NeedsTwoInARow) {
  NoisePlateau plateau(0.1, 1000, 1);
  plateau.add(50, 0.14);
  EXPECT_FALSE(plateau.add(80, 0.139));
  EXPECT_FALSE(plateau.add(120, 0.1));  // a fall between
  EXPECT_FALSE(plateau.add(200, 0.0999));
}

TEST(Status, NamesAreAllDifferent) {
  std::set<std::string_view> names;
  for (Status s : {Status::not_run, Status::fixed_size, Status::reached, Status::not_reached,
                   Status::data_too_sparse, Status::tolerance_below_noise, Status::folded,
                   Status::limit_reached, Status::time_limit, Status::stopped, Status::failed})
    EXPECT_TRUE(names.insert(to_string(s)).second) << to_string(s);
  EXPECT_FALSE(names.contains("unknown"));
  EXPECT_EQ(to_string(Status::data_too_sparse), "data_too_sparse");
}

}  // namespace
}  // namespace knotfit::test
