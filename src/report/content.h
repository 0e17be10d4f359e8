// What a picture shows, prepared once from its input.
#pragma once
#include <string>
#include <vector>

#include "knotfit/picture.h"
#include "report/colour_map.h"
#include "report/error_field.h"
#include "report/surface_samples.h"
namespace knotfit::report {

/// What the surface's colour means.
enum class Colouring { error, height, plain };

struct Content {
  const PictureInput* input = nullptr;
  Domain domain;     ///< of the surface
  ParameterMap map;  ///< to the user's parameters
  SurfaceSamples samples;
  Colouring colouring = Colouring::plain;
  ErrorScale scale;
  ErrorField errors;
  ThinField thin;
  OpeningField openings;
  bool gaps = false;  ///< somewhere no data is near: drawn grey and hatched
  Index point_count = 0;
  Index worst = -1;  ///< point with the largest |error|
  double rms = 0, max = 0;

  const ParameterizedPoints& points() const { return *input->points; }
  /// Colour of the surface at (u, v) where its height is z; no colour where errors are shown and
  /// none is near, and over openings.
  std::optional<Rgb> colour_at(double u, double v, double z) const;
};

/// \param most  surface samples wanted a direction
/// \throws InvalidInput  no surface, a dimension without a picture, errors that do not fit the points
Content prepare(const PictureInput& input, int most);

inline constexpr Rgb kInk{0.12, 0.14, 0.18};       // text and lines
inline constexpr Rgb kQuiet{0.40, 0.43, 0.48};     // secondary text
inline constexpr Rgb kMaterial{0.80, 0.82, 0.85};  // a surface without a colour of its own
inline constexpr Rgb kFold{0.78, 0.05, 0.55};      // where the surface folds
inline constexpr Rgb kNoData{0.72, 0.72, 0.73};    // where no data is near

}  // namespace knotfit::report
