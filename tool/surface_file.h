// Files that hold surfaces: knotfit JSON, JSON of other programs, STEP and IGES.
#pragma once
#include <string>
#include <vector>

#include "knotfit/io.h"
#include "options.h"
namespace knotfit::tool {

/// The file holds surfaces and not data: by --input-format, else by its extension; standard input by its first letter.
bool holds_surfaces(const std::string& path, const InputOptions& options);
bool is_cad_file(const std::string& path);

/// Every surface of the file. Where it does not say how its parameters are meant, the knots are brought to [0,1]
/// and the map tells their own range.
std::vector<SurfaceDocument> read_surfaces(const std::string& path, const SurfaceChoices& choices);

/// --unit is given for a surface that has none: that of a JSON file.
/// \throws InvalidInput  names the option
void refuse_idle_surface_options(const std::string& path, const SurfaceChoices& choices);

/// The one that --face names, or the only one.
/// \throws InvalidInput  there are several, or none of that number
SurfaceDocument read_one_surface(const std::string& path, const SurfaceChoices& choices);

/// The surface in space that the document means: its own, or that of a height field over the user's x and y.
/// \throws InvalidInput  with the words of `otherwise`, where it is neither
Surface surface_in_space(const SurfaceDocument& document, const std::string& otherwise);

}  // namespace knotfit::tool
