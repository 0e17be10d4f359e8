// Colours of errors and heights, safe for colour-blind readers.
#pragma once
#include <array>
#include <string>
#include <vector>
namespace knotfit::report {

/// sRGB, each in [0,1].
struct Rgb {
  double r = 0, g = 0, b = 0;
};
Rgb mix(const Rgb& a, const Rgb& b, double share_of_b);
/// Oklab lightness, a (green to red), b (blue to yellow) [Ottosson20].
std::array<double, 3> to_oklab(const Rgb& colour);
/// The nearest sRGB colour: chroma is reduced where the screen cannot show it.
Rgb from_oklab(const std::array<double, 3>& lab);

/// Blue for t < 0, orange for t > 0, light grey at 0; equally light at -t and t, darker and more
/// colourful away from 0. \param t  clamped to [-1,1]
Rgb diverging(double t);
/// Dark blue over green to pale yellow, lightness linear in t. \param t  clamped to [0,1]
Rgb sequential(double t);

/// How signed errors become colours: pale within the tolerance, a clear step at it.
struct ErrorScale {
  double range = 1;        ///< error of the full colour, > 0
  double tolerance = 0;    ///< 0: none
  bool one_sided = false;  ///< all errors are >= 0: a scale from 0
  bool clipped = false;    ///< some errors are beyond `range`
  double largest = 0;      ///< largest |error|

  /// Position on the diverging map, in [-1,1], odd in e.
  double position(double e) const;
  Rgb colour(double e) const { return diverging(position(e)); }
};

/// Range from the errors: the largest, but not so far out that a few spikes hide all others, and
/// at least 1.5 tolerances.
ErrorScale error_scale(const std::vector<double>& signed_errors, double tolerance);

}  // namespace knotfit::report
