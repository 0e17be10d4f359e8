// Airfoils: a name above the points, and both surfaces apart.
#include <algorithm>

#include "text_curves.h"
namespace knotfit::test {
namespace {

using Doubles = std::vector<double>;
using Lines = std::vector<Index>;
using Words = std::vector<std::string>;

TEST(LeadingLines, NamesOfAirfoilsMayHoldNumbers) {
  for (const char* name : {"NACA 2412", "CLARK Y", "EPPLER 205 AIRFOIL", "RAF-15", "\"Wing, 2 m\"",
                           "MH 32  8.7%", "12 percent section of mine", "Profil Gö 417", "s"}) {
    SCOPED_TRACE(name);
    const SourceData data = curve(std::string(name) + "\n 1.0  0.1\n 0.5  0.2\n 0.0  0.0\n");
    const PointTable t = content<PointTable>(data);
    EXPECT_EQ(t.x, (Doubles{1, 0.5, 0}));
    EXPECT_EQ(t.y, (Doubles{0.1, 0.2, 0}));
    EXPECT_EQ(t.line, (Lines{2, 3, 4}));
    EXPECT_EQ(data.columns, (Words{"x", "y"}));
    expect_note(data, "line 1 left out, a title");
  }
}

TEST(Lednicer, BothSurfacesBecomeOneProfile) {
  const char* upper = " 0.0 0.0\n 0.5 0.1\n 1.0 0.01\n";
  const char* lower = " 0.0 0.0\n 0.25 -0.1\n 0.5 -0.05\n 1.0 -0.01\n";
  for (const char* gap : {"\n", ""}) {
    const SourceData data = curve(std::string("MY 12 SECTION\n 3. 4.\n") + gap + upper + gap + lower);
    const PointTable t = content<PointTable>(data);
    EXPECT_EQ(t.x, (Doubles{1, 0.5, 0, 0.25, 0.5, 1}));
    EXPECT_EQ(t.y, (Doubles{0.01, 0.1, 0, -0.1, -0.05, -0.01}));
    EXPECT_EQ(t.line.front(), *gap != 0 ? 6 : 5);
    expect_note(data, "joined to one profile; the nose stands there once");
    expect_note(data, "3 points of the upper surface from the tail to the nose and 4 of the lower");
  }
  // One surface alone can be had.
  const std::string text = std::string("A\n3 4\n\n") + upper + "\n" + lower;
  EXPECT_EQ(content<PointTable>(curve(text, "a.dat", 2)).y, (Doubles{0, -0.1, -0.05, -0.01}));
  // Two noses stay two.
  const SourceData two = curve(std::string("A\n3 3\n\n") + upper + "\n 0.0 -0.001\n 0.5 -0.1\n 1 0\n");
  EXPECT_EQ(content<PointTable>(two).size(), 6);
}

TEST(Lednicer, OtherBlocksAreNotJoined) {
  // The counts are wrong; the second surface runs back.
  expect_throw<FileError>([&] { curve("A\n3. 9.\n\n0 0\n.5 .1\n1 0\n\n0 0\n.5 -.1\n1 0\n"); },
                          "2 blocks of points");
  expect_throw<FileError>([&] { curve("A\n3. 3.\n\n0 0\n.5 .1\n1 0\n\n1 0\n.5 -.1\n0 0\n"); },
                          "2 blocks of points");
}

}  // namespace
}  // namespace knotfit::test
