// Files that hold surfaces: knotfit JSON, JSON of other programs, STEP and IGES.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "knotfit/io.h"
#include "options.h"
namespace knotfit::tool {

/// The file holds surfaces and not data: by --input-format, else by its extension; standard input by its first letter.
bool holds_surfaces(const std::string& path, const InputOptions& options);
bool is_cad_file(const std::string& path);

/// A face of the file: its surface, or why that is not usable.
struct FileFace {
  std::optional<SurfaceDocument> document;
  std::string kind, why;  ///< as CadFace
  bool trimmed = false;
};

/// --unit is given for a surface that has none: that of a JSON file.
/// \throws InvalidInput  names the option
void refuse_idle_surface_options(const std::string& path, const SurfaceChoices& choices);

/// Every face of a CAD file, in its order; the surface of a JSON file, or of "-" that of standard input. Where it does
/// not say how its parameters are meant, the knots are brought to [0,1] and the map tells their own range.
std::vector<FileFace> read_faces(const std::string& path, const SurfaceChoices& choices);

/// The one that --face names, or the only one that is usable.
/// \throws InvalidInput  there are several, none of that number, or none that is usable; says why
SurfaceDocument read_one_surface(const std::string& path, const SurfaceChoices& choices);

/// The surface in space that the document means: its own, or that of a height field over the user's x and y.
/// \throws InvalidInput  with the words of `otherwise`, where it is neither
Surface surface_in_space(const SurfaceDocument& document, const std::string& otherwise);

}  // namespace knotfit::tool
