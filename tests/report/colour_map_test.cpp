#include "report/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>
namespace knotfit::report {
namespace {

double chroma(const Rgb& c) {
  const auto lab = to_oklab(c);
  return std::hypot(lab[1], lab[2]);
}

double distance(const Rgb& a, const Rgb& b) {
  const auto x = to_oklab(a), y = to_oklab(b);
  return std::hypot(x[0] - y[0], std::hypot(x[1] - y[1], x[2] - y[2]));
}

double linear(double s) {
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}
double gamma(double l) {
  l = std::clamp(l, 0.0, 1.0);
  return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
}

// What a reader without one kind of cone sees, severity 1 [Machado09].
using Matrix = double[3][3];
constexpr Matrix kDeuteranopia{
    {0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};
constexpr Matrix kProtanopia{
    {0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}};
constexpr Matrix kTritanopia{
    {1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}};

Rgb seen(const Matrix& m, const Rgb& c) {
  const double in[3] = {linear(c.r), linear(c.g), linear(c.b)};
  double out[3];
  for (int i = 0; i < 3; ++i) out[i] = gamma(m[i][0] * in[0] + m[i][1] * in[1] + m[i][2] * in[2]);
  return {out[0], out[1], out[2]};
}

TEST(Oklab, ComesBackToTheColourItCameFrom) {
  for (double r : {0.0, 0.02, 0.4, 1.0})
    for (double g : {0.0, 0.3, 1.0})
      for (double b : {0.0, 0.7, 1.0}) {
        const Rgb back = from_oklab(to_oklab({r, g, b}));
        // The two published matrices invert each other to their ten digits; the gamma's slope is 12.92.
        EXPECT_NEAR(back.r, r, 1e-5);
        EXPECT_NEAR(back.g, g, 1e-5);
        EXPECT_NEAR(back.b, b, 1e-5);
      }
}

TEST(Oklab, KeepsLightnessWhereTheScreenCannotShowTheChroma) {
  const auto lab = to_oklab(from_oklab({0.7, -0.5, 0.3}));
  EXPECT_NEAR(lab[0], 0.7, 1e-4);
  EXPECT_NEAR(lab[1] / lab[2], -0.5 / 0.3, 1e-2);  // the hue too
}

TEST(DivergingColours, AreNeutralAtZeroAndSymmetricInLightness) {
  EXPECT_LT(chroma(diverging(0)), 1e-4);
  for (double t = 0; t <= 1; t += 0.01)
    EXPECT_NEAR(to_oklab(diverging(t))[0], to_oklab(diverging(-t))[0], 1e-4) << t;
}

TEST(DivergingColours, GetDarkerAwayFromZero) {
  for (double sign : {-1.0, 1.0})
    for (double t = 0; t < 0.999; t += 0.01)
      EXPECT_LT(to_oklab(diverging(sign * (t + 0.01)))[0], to_oklab(diverging(sign * t))[0]) << sign * t;
}

TEST(DivergingColours, TellTheSignsApartForColourBlindReaders) {
  // 0.02 is about a just noticeable difference in Oklab.
  for (double t = 0.36; t <= 1; t += 0.04) {
    EXPECT_GT(distance(diverging(t), diverging(-t)), 0.10) << t;
    for (const Matrix* m : {&kDeuteranopia, &kProtanopia, &kTritanopia})
      EXPECT_GT(distance(seen(*m, diverging(t)), seen(*m, diverging(-t))), 0.08) << t;
  }
}

TEST(DivergingColours, ClampBeyondTheEnds) {
  EXPECT_EQ(distance(diverging(7), diverging(1)), 0);
  EXPECT_EQ(distance(diverging(-7), diverging(-1)), 0);
}

TEST(SequentialColours, GetLighterAllTheWay) {
  for (double t = 0; t < 0.999; t += 0.01)
    EXPECT_GT(to_oklab(sequential(t + 0.01))[0], to_oklab(sequential(t))[0]) << t;
}

TEST(ErrorScale, IsOddAndMonotone) {
  const ErrorScale scale = error_scale({-3, 1, 2}, 0.5);
  double last = -2;
  for (double e = -3.2; e <= 3.2; e += 0.05) {
    EXPECT_EQ(scale.position(e), -scale.position(-e));
    EXPECT_GE(scale.position(e), last);
    last = scale.position(e);
  }
  EXPECT_EQ(scale.position(3), 1);
}

TEST(ErrorScale, IsPaleWithinTheToleranceAndClearlyColouredBeyond) {
  const ErrorScale scale = error_scale({-3, 1, 2}, 1);
  for (double sign : {-1.0, 1.0}) {
    EXPECT_LT(chroma(scale.colour(sign * 0.3)), 0.02);
    EXPECT_LT(chroma(scale.colour(sign)), 0.05);
    EXPECT_GT(chroma(scale.colour(sign * 1.001)), 0.08);
    EXPECT_GT(distance(scale.colour(sign), scale.colour(sign * 1.001)), 0.1);
  }
}

TEST(ErrorScale, ReachesBeyondAToleranceThatHolds) {
  const ErrorScale scale = error_scale({-0.1, 0.2}, 1);
  EXPECT_EQ(scale.range, 1.5);
  EXPECT_FALSE(scale.clipped);
}

TEST(ErrorScale, DoesNotLetOneSpikeHideAllOthers) {
  std::vector<double> errors(10000);
  for (std::size_t k = 0; k < errors.size(); ++k) errors[k] = (k % 2 ? 1 : -1) * static_cast<double>(k) / 1e4;
  errors[77] = 1000;
  const ErrorScale scale = error_scale(errors, 0);
  EXPECT_TRUE(scale.clipped);
  EXPECT_LE(scale.range, 1.5);
  EXPECT_EQ(scale.largest, 1000);
}

TEST(ErrorScale, IsOneSidedWhereErrorsHaveNoSign) {
  EXPECT_TRUE(error_scale({0, 1, 2}, 0).one_sided);
  EXPECT_FALSE(error_scale({0, -1, 2}, 0).one_sided);
  EXPECT_FALSE(error_scale({0, 0, 0}, 0).one_sided);
}

TEST(ErrorScale, HasARangeWhereAllErrorsAreZero) {
  const ErrorScale scale = error_scale({0, 0}, 0);
  EXPECT_GT(scale.range, 0);
  EXPECT_EQ(scale.position(0), 0);
}

}  // namespace
}  // namespace knotfit::report
