// Oblique features of height fields: parameters along them, so that fewer knots do.
//
// Knot lines run along the parameters. A ridge that crosses them needs knots everywhere; one that runs along them needs
// knots in one direction only [METHOD 4.7].
#pragma once
#include "knotfit/fit_surface.h"
namespace [[gnu::visibility("default")]] knotfit {

/// ParameterMap::shear_u and shear_v: in [-1,1], one of them 0.
struct Shear {
  double u = 0, v = 0;
};

/// The shear at which the error model's knots, 12 a direction (fewer for few points), leave the least RMS error on at
/// most 10 000 of the points: steps of 0.1, then finer about the best. None where it gains less than a tenth.
/// \throws InvalidInput  not a height field
Shear find_shear(const ParameterizedPoints& points, const FitOptions& options, const Control& control = {});

struct ShearedFit {
  FitResult result;
  ParameterizedPoints points;  ///< at the parameters of the result
};

/// fit_surface() at the parameters given and at `shear` (none: find_shear()); keeps what reaches the tolerance with
/// fewer control points, at a fixed size what errs less, and says so among the notes.
/// \throws InvalidInput  see fit_surface(), find_shear(), sheared()
ShearedFit fit_sheared(const ParameterizedPoints& points, const FitOptions& options,
                       std::optional<Shear> shear = std::nullopt, const Control& control = {});

}  // namespace knotfit
