// Output files: which there are by extension, checked before long work, written whole or not at all.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "knotfit/io.h"
#include "knotfit/picture.h"
#include "knotfit/points.h"
#include "knotfit/source_data.h"
#include "knotfit/surface.h"
#include "options.h"
namespace knotfit::tool {

enum class OutputKind { surface, table, raster, picture, mesh, cad };

struct OutputFile {
  std::string path;
  OutputKind kind = OutputKind::surface;
  std::string extension;  ///< lower case, with its dot
};

/// formats(), with the pictures and what the tool reads beside data.
std::vector<FormatInfo> all_formats();

/// What each path asks for, every one checked: extension, folder, permission, existing files. "-" is the surface's
/// JSON on standard output.
/// \param input  never replaced, not even with force
/// \throws InvalidInput  unknown extension (lists those there are), a path twice or equal to input
/// \throws FileError     see check_writable
std::vector<OutputFile> plan_outputs(const OutputOptions& output, const std::string& input);

bool asks_for(const std::vector<OutputFile>& outputs, OutputKind kind);

/// An empty grid of cells over a height field's domain: centres from the first corner in steps of
/// the cell, as far as they stay inside, so that a raster's own cell size gives its own grid back.
/// \throws InvalidInput  more than 4e8 cells
Raster grid_over(const ParameterMap& map, std::pair<double, double> cell);

/// Heights of the surface at the centres of `grid`.
void fill_heights(Raster& grid, const Surface& surface, const ParameterMap& map);

/// Makes holes of the cells of `grid` whose nearest cell of `source` is a hole, and takes its
/// nodata value over.
void keep_holes(Raster& grid, const Raster& source);

/// A nodata value that no height of the raster has: its own, else -9999, else lower.
double free_nodata(const Raster& raster);

void write_raster_file(const std::string& path, bool force, Raster raster);
void write_text_file(const std::string& path, bool force, const std::string& text);
void write_picture_file(const OutputFile& file, bool force, const PictureInput& picture);

/// Every file is tried, so that one full disk does not cost the others; what goes wrong is said on standard error.
/// \param written  the paths of those that were  \return kReached, or the exit status of what went wrong
int write_each(const std::vector<OutputFile>& files, const std::function<void(const OutputFile&)>& write,
               std::vector<std::string>& written);

/// A summary for people: on standard output, or on standard error where an output file is standard output.
void print_summary(const std::string& text, const std::vector<OutputFile>& files);

/// A line "wrote PATH" a file that was written.
std::string wrote(const std::vector<std::string>& paths);
std::string wrote(const std::vector<OutputFile>& files);

/// Standard output, whole. \throws WriteError  it cannot take it
void print(const std::string& text);

}  // namespace knotfit::tool
