#include "report/colour_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
namespace knotfit::report {
namespace {

double to_linear(double s) {
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}
double from_linear(double l) {
  return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
}

// Matrices of [Ottosson20], "A perceptual color space for image processing".
std::array<double, 3> linear_rgb(const std::array<double, 3>& lab) {
  const double l = lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2];
  const double m = lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2];
  const double s = lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2];
  const double l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  return {4.0767416621 * l3 - 3.3077115913 * m3 + 0.2309699292 * s3,
          -1.2684380046 * l3 + 2.6097574011 * m3 - 0.3413193965 * s3,
          -0.0041960863 * l3 - 0.7034186147 * m3 + 1.7076147010 * s3};
}

std::array<double, 3> from_hue(double lightness, double chroma, double degrees) {
  const double h = degrees * std::numbers::pi / 180;
  return {lightness, chroma * std::cos(h), chroma * std::sin(h)};
}

constexpr double kNeutralLightness = 0.87, kEndLightness = 0.42;
constexpr double kInside = 0.13;   // position reached at the tolerance: a faint tint
constexpr double kOutside = 0.36;  // position just beyond it: a clear step

}  // namespace

Rgb mix(const Rgb& a, const Rgb& b, double s) {
  return {a.r + s * (b.r - a.r), a.g + s * (b.g - a.g), a.b + s * (b.b - a.b)};
}

std::array<double, 3> to_oklab(const Rgb& c) {
  const double r = to_linear(c.r), g = to_linear(c.g), b = to_linear(c.b);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Rgb from_oklab(const std::array<double, 3>& lab) {
  auto inside = [](const std::array<double, 3>& c) {
    return std::all_of(c.begin(), c.end(), [](double x) { return x >= -1e-9 && x <= 1 + 1e-9; });
  };
  std::array<double, 3> linear = linear_rgb(lab);
  if (!inside(linear)) {
    double low = 0, high = 1;  // share of the chroma that the screen can show
    for (int step = 0; step < 30; ++step) {
      const double middle = (low + high) / 2;
      (inside(linear_rgb({lab[0], middle * lab[1], middle * lab[2]})) ? low : high) = middle;
    }
    linear = linear_rgb({lab[0], low * lab[1], low * lab[2]});
  }
  auto channel = [](double x) { return std::clamp(from_linear(std::clamp(x, 0.0, 1.0)), 0.0, 1.0); };
  return {channel(linear[0]), channel(linear[1]), channel(linear[2])};
}

Rgb diverging(double t) {
  t = std::clamp(t, -1.0, 1.0);
  const double a = std::abs(t);
  const double lightness = kNeutralLightness + a * (kEndLightness - kNeutralLightness);
  // Chroma rises fast, then stays: dark colours hold less of it.
  const double chroma = 0.165 * (1 - (1 - a) * (1 - a));
  return from_oklab(t < 0 ? from_hue(lightness, chroma, 252) : from_hue(lightness, chroma, 54 + 4 * (1 - a)));
}

Rgb sequential(double t) {
  t = std::clamp(t, 0.0, 1.0);
  const double hue = 262 - 158 * std::pow(t, 1.1);  // blue, green, yellow
  return from_oklab(from_hue(0.46 + 0.48 * t, 0.085 + 0.05 * std::sin(std::numbers::pi * t), hue));
}

double ErrorScale::position(double e) const {
  const double a = std::abs(e);
  double t = 0;
  if (tolerance <= 0)
    t = a / range;
  else if (a <= tolerance)
    t = kInside * a / tolerance;
  else
    t = kOutside + (1 - kOutside) * (a - tolerance) / std::max(range - tolerance, 1e-3 * tolerance);
  return std::copysign(std::min(t, 1.0), e);
}

ErrorScale error_scale(const std::vector<double>& signed_errors, double tolerance) {
  ErrorScale scale;
  scale.tolerance = std::max(tolerance, 0.0);
  if (signed_errors.empty()) return scale;
  std::vector<double> size(signed_errors.size());
  std::transform(signed_errors.begin(), signed_errors.end(), size.begin(),
                 [](double e) { return std::abs(e); });
  scale.largest = *std::max_element(size.begin(), size.end());
  scale.one_sided =
      scale.largest > 0 &&
      std::all_of(signed_errors.begin(), signed_errors.end(), [](double e) { return e >= 0; }) &&
      signed_errors.size() > 1;
  const std::size_t rank =
      std::min(size.size() - 1, static_cast<std::size_t>(0.998 * static_cast<double>(size.size())));
  std::nth_element(size.begin(), size.begin() + static_cast<std::ptrdiff_t>(rank), size.end());
  const double most = std::max(1.5 * size[rank], 4 * scale.tolerance);
  scale.clipped = scale.largest > 2.5 * most && most > 0;
  scale.range = std::max(scale.clipped ? most : scale.largest, 1.5 * scale.tolerance);
  if (!(scale.range > 0)) scale.range = 1;  // every error is zero, no tolerance
  return scale;
}

}  // namespace knotfit::report
