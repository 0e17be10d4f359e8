#include "formats/surface_net.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

const std::string kPath = "a.json";

ControlNet net(const std::string& text, Index size_u, Index size_v, bool v_major = false) {
  return read_control_net(JsonReader(text, text, kPath), text, size_u, size_v, v_major);
}

using Doubles = std::vector<double>;

TEST(SurfaceNet, IsTheSameInEveryWayToWriteIt) {
  const Doubles points = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};  // 2 x 3 points of 2 components
  for (const char* text : {"[[[1,2],[3,4],[5,6]],[[7,8],[9,10],[11,12]]]",
                           "[[1,2],[3,4],[5,6],[7,8],[9,10],[11,12]]", "[1,2,3,4,5,6,7,8,9,10,11,12]"}) {
    const ControlNet read = net(text, 2, 3);
    EXPECT_EQ(read.dimension, 2) << text;
    EXPECT_EQ(read.points, points) << text;
  }
  EXPECT_EQ(net("[[1,2,3],[4,5,6]]", 2, 3).dimension, 1) << "numbers by rows";
}

TEST(SurfaceNet, WithVSlowestIsTurned) {
  const Doubles points = {1, 2, 3, 4, 5, 6};
  for (const char* text : {"[[[1],[4]],[[2],[5]],[[3],[6]]]", "[1,4,2,5,3,6]"})
    EXPECT_EQ(net(text, 2, 3, true).points, points) << text;
}

TEST(SurfaceNet, NumbersThatDoNotFillItAreSaid) {
  const auto bad = [](const std::string& text, const std::string& words) {
    test::expect_throw<FileError>([&] { net(text, 2, 3); }, words);
  };
  bad("[[[1],[2],[3]]]", "1 rows, but degree and knots_u ask for 2");
  bad("[[[1],[2]],[[3],[4],[5]]]", "row 0 (from 0) has 2 points, but degree and knots_v ask for 3");
  bad("[[[1],[2],[3]],[[4],[5,6],[7]]]", "point (1, 1) has 2 components, the first point has 1");
  bad("[1,2,3,4]", "4 numbers are no 2 x 3 control points");
  bad("[[1,2],[3,4]]", "2 entries of 2 numbers are no 2 x 3 control points");
}

}  // namespace
}  // namespace knotfit
