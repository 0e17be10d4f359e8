// The outputs of a fit: each kind of file from its report.
#pragma once
#include <string>
#include <vector>

#include "fit_report.h"
#include "outputs.h"
namespace knotfit::tool {

/// The grid of an .asc output, checked before the fit: nothing is found out after minutes.
/// \throws InvalidInput  no height field, or scattered points without --cell
Raster output_grid(const FitInput& input, const FitChoices& choices);

/// Of the grid's nodes those over scattered points (grid_support()); empty: all have heights.
std::vector<char> output_support(const Raster& grid, const FitInput& input, const FitResult& result,
                                 const FitChoices& choices);

/// What a fit writes, a file at a time.
class FitWriter {
 public:
  /// \param grid, support  of a raster's output; empty where there is none
  FitWriter(const FitReport& report, const Raster& grid, const std::vector<char>& support, bool force,
            bool reflections)
      : report_(report), grid_(grid), support_(support), force_(force), reflections_(reflections) {}

  void write(const OutputFile& file) const;
  /// The picture as bytes. \param extension  with its dot
  std::string draw(const std::string& extension, const PictureOptions& options = {}) const;
  /// The document of the .json output.
  std::string surface_json() const;

 private:
  PictureInput picture() const;

  const FitReport& report_;
  const Raster& grid_;
  const std::vector<char>& support_;
  bool force_, reflections_;
  mutable ParameterizedPoints feet_;  ///< what a picture draws
};

}  // namespace knotfit::tool
