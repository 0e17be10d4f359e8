// Files in and out. The format follows the extension, or is named.
#pragma once
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "knotfit/index.h"
#include "knotfit/points.h"
#include "knotfit/source_data.h"
#include "knotfit/surface.h"
namespace [[gnu::visibility("default")]] knotfit {

struct FormatInfo {
  std::string_view name;        ///< "esri-ascii"
  std::string_view extensions;  ///< ".asc .grd"
  std::string_view summary;
  bool reads = false, writes = false;
};
/// Every format there is.
std::span<const FormatInfo> formats();

inline constexpr int kLastReturn = -1;  ///< the last return of every pulse, whatever its number

struct ReadOptions {
  std::string format;  ///< empty: by extension, then content
  std::vector<std::string>
      columns;  ///< names of the columns of a text file or n x k array: x y z u v w nx ny nz; others, "-": left out
  /// What stands for missing data: a value of z (of a raster in place of its header's), or NaN for every word that
  /// does (nan, NA, null, an empty cell). Cells become holes, points are left out and counted.
  std::optional<double> nodata;
  std::vector<int> classes;     ///< of LAS points, such as 2 for ground; empty: all
  std::vector<int> returns;     ///< of LAS points: 1 the first, ...; kLastReturn; empty: all
  bool places = false;          ///< a table may lack z (places to evaluate at): its z are then NaN
  bool curve = false;           ///< points of one curve in order: two columns are x, y; blocks are not joined
  Index block = 0;              ///< of the blocks of a text, from 1; 0: all
  Index skip_lines = 0;         ///< lines of a text that are left out before anything is read
  bool any_parameters = false;  ///< u and v may have any range: they are rescaled later
};
/// Reads a data file. Memory is taken only once the file's size can hold what its header claims.
/// \throws FileError  missing, empty, truncated, malformed; names the line or byte
SourceData read_data(const std::string& path, const ReadOptions& options = {});

/// A surface with what belongs to it in a knotfit JSON file.
struct SurfaceDocument {
  Surface surface;
  ParameterMap map;
  bool height_field = false;
  std::string options;  ///< the options in force, a JSON object as text; empty: none
  std::string result;   ///< what was measured, a JSON object as text; empty: none
};
/// A height field over the user's (x, y) as a surface in space. Of a sheared one the parallelogram's bounding patch:
/// what lies outside the user's rectangle has no data.
/// \throws InvalidInput  dimension of `height` is not 1
Surface height_field_in_space(const Surface& height, const ParameterMap& map);
/// The documented schema (docs/formats.md); doubles round-trip exactly.
std::string to_json(const SurfaceDocument& document);
/// \throws FileError  not JSON, not a surface, or a foreign schema; names the member
SurfaceDocument read_surface(const std::string& path);
SurfaceDocument surface_from_json(std::string_view text, const std::string& path);

/// Writes beside the target, flushes to disk and renames: never half a file.
/// \param force  replace an existing file
/// \throws FileError  the folder does not exist, the target exists and not force, cannot be opened
/// \throws WriteError  writing failed (full disk); nothing is left behind
void write_file(const std::string& path, bool force, const std::function<void(std::ostream&)>& write);
/// The checks of write_file without writing: for a clear word before long work.
void check_writable(const std::string& path, bool force);

/// Columns x,y,z,u,v,error (height fields and geometry; x,y left out where there are none), a line
/// a point in input order. u, v are in the user's parameters; those of a height field are x and y, and
/// u, v there are the surface's own in [0,1].
void write_residuals(std::ostream& out, const ParameterizedPoints& points, std::span<const double> errors);
/// ESRI ASCII grid, holes as nodata.
void write_raster(std::ostream& out, const Raster& raster);

}  // namespace knotfit
