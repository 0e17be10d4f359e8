#include "place/row_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/place.h"
#include "place/trials.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

TEST(RowMethods, SayThatScatteredDataWasResampled) {
  const ParameterizedPoints points = synthetic_points("franke", 4000);
  for (const char* method : {"nktp", "dominant", "derivative-share"}) {
    const Placement placement = place_knots(method, points);
    ASSERT_EQ(placement.notes.size(), 1u) << method;
    EXPECT_NE(placement.notes[0].find("resampled on 101 x 101 lines"), std::string::npos)
        << placement.notes[0];
  }
  EXPECT_TRUE(place_knots("fitpack", points).notes.empty());
}

TEST(RowShape, IsTheTurningAngleAndTheLength) {
  // A roof: every row turns by the same angle at u = 0.5.
  ParameterizedPoints points = grid_of(11, 4, [](double u, double) { return std::abs(u - 0.5); });
  FitProblem problem(points, 3, 3);
  const RowGrid grid = make_row_grid(problem, {});
  EXPECT_TRUE(grid.note.empty());
  const RowShape shape = row_shape(grid, false);
  for (int i = 0; i < 11; ++i) EXPECT_NEAR(shape.bend[i], i == 5 ? 4 * std::numbers::pi / 2 : 0, 1e-7) << i;
  for (int i = 1; i < 11; ++i) EXPECT_NEAR(shape.length[i], 4 * 0.1 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(shape.length[0], 0);
  const RowShape across = row_shape(grid, true);
  for (double b : across.bend) EXPECT_NEAR(b, 0, 1e-7);
  EXPECT_NEAR(across.length[1], 11 / 3.0, 1e-12);
}

}  // namespace
}  // namespace knotfit::test
