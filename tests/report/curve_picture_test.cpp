#include "knotfit/curve_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

TEST(CurvePicture, DrawsEveryDimensionAndFormat) {
  Random random(3);
  for (int dimension : {1, 2, 3}) {
    const Curve curve = random_curve(random, dimension, Ends::clamped);
    CurvePictureInput input;
    input.curve = &curve;
    for (int k = 0; k < 50; ++k) input.t.push_back(random_parameter(random, curve.knots()));
    input.points = evaluate(curve, input.t);
    input.errors.assign(50, 0.0);
    input.errors[7] = 1;
    input.title = "a curve";
    for (const char* extension : {".svg", ".png", ".pdf"}) {
      const std::string picture = draw_curve_picture(input, extension);
      EXPECT_GT(picture.size(), 500u);
      EXPECT_EQ(picture, draw_curve_picture(input, extension));
    }
  }
}

TEST(CurvePicture, DrawsAStraightLineAndNoPoints) {
  const Curve line(KnotVector::uniform(1, 0), 2, {0, 5, 3, 5});
  CurvePictureInput input;
  input.curve = &line;
  EXPECT_FALSE(draw_curve_picture(input, ".svg", {.width = 200, .height = 200}).empty());
}

TEST(CurvePicture, RefusesWhatItCannotDraw) {
  CurvePictureInput input;
  expect_throw<InvalidInput>([&] { draw_curve_picture(input, ".svg"); }, "needs a curve");
  const Curve line(KnotVector::uniform(1, 0), 2, {0, 5, 3, 5});
  input.curve = &line;
  input.t = {0.5};
  expect_throw<InvalidInput>([&] { draw_curve_picture(input, ".svg"); }, "0 numbers are no 1 points");
  input.points = {1, 2};
  input.errors = {1, 2};
  expect_throw<InvalidInput>([&] { draw_curve_picture(input, ".svg"); }, "2 errors for 1 points");
  input.errors = {NAN};
  expect_throw<InvalidInput>([&] { draw_curve_picture(input, ".svg"); }, "not finite");
  expect_throw<InvalidInput>([&] { draw_curve_picture(input, ".bmp"); }, ".bmp");
}

}  // namespace
}  // namespace knotfit::test
