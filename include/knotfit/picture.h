// Pictures: the shaded surface with its isolines and errors, the parameter plane beside it.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "knotfit/folds.h"
#include "knotfit/points.h"
#include "knotfit/surface.h"
#include "knotfit/verify.h"
namespace [[gnu::visibility("default")]] knotfit {

struct PictureInput {
  const Surface* surface = nullptr;             ///< height field (dimension 1) or in R^3
  const ParameterizedPoints* points = nullptr;  ///< the data fitted
  /// One a point: signed S - P for height fields, signed by the normal in R^3; empty: no errors.
  std::vector<double> signed_errors;
  double tolerance = 0;                ///< neutral colour within it; 0: none
  std::string unit;                    ///< of errors, for the legend; may be empty
  std::string title, subtitle;         ///< drawn on top
  std::vector<ThinPlace> thin_places;  ///< hatched in the parameter plane
  /// The surface shows reflection lines in place of errors: a row of lamps 10 degrees apart, as its normals mirror
  /// them to the eye. The parameter plane stays as it is.
  bool reflections = false;
  /// Triangles of the parameter plane, (u, v) of each corner, over openings of the data: grey and hatched, on the surface too.
  std::vector<std::array<double, 6>> openings;
  std::vector<FoldPlace> fold_places;  ///< circled in the parameter plane, as large as their share of it
};
struct PictureOptions {
  int width = 1600, height = 900;  ///< pixels (png) or points (svg, pdf)
};
/// Draws to a .png, .svg or .pdf file image in memory; `extension` with its dot.
/// \throws InvalidInput  another extension, or sizes outside 200 to 20000
std::string draw_picture(const PictureInput& input, const std::string& extension,
                         const PictureOptions& options = {});

/// S - P of each point, signed: the difference for height fields, by the surface normal in R^3.
std::vector<double> signed_errors(const Surface& surface, const ParameterizedPoints& points);

}  // namespace knotfit
