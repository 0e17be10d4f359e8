#include "outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <ostream>

#include "exit_status.h"
#include "knotfit/cad.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "remedy_words.h"
#include "standard_streams.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

namespace fs = std::filesystem;

struct Extension {
  std::string_view name;
  OutputKind kind;
  std::string_view what;
};
constexpr Extension kExtensions[] = {
    {".json", OutputKind::surface, "the surface"},
    {".csv", OutputKind::table, "a table of points"},
    {".asc", OutputKind::raster, "heights"},
    {".grd", OutputKind::raster, "heights"},
    {".png", OutputKind::picture, "a picture"},
    {".svg", OutputKind::picture, "a picture"},
    {".pdf", OutputKind::picture, "a picture"},
    {".obj", OutputKind::mesh, "a mesh"},
    {".ply", OutputKind::mesh, "a mesh"},
    {".vts", OutputKind::mesh, "a VTK grid"},
    {".step", OutputKind::cad, "STEP"},
    {".stp", OutputKind::cad, "STEP"},
    {".igs", OutputKind::cad, "IGES"},
    {".iges", OutputKind::cad, "IGES"},
};
// Formats that have their place, but not in this version.
constexpr std::string_view kLater[] = {".stl", ".off",  ".vtk", ".vtu", ".vtp",
                                       ".tif", ".tiff", ".las", ".laz", ".npy"};

constexpr double kMostCells = 4e8;

std::string extensions() {
  std::string list;
  for (const Extension& e : kExtensions) {
    if (!list.empty()) list += ", ";
    list += fmt::format("{} ({})", e.name, e.what);
  }
  return list;
}

OutputFile classify(const std::string& path) {
  if (is_dash(path)) return {path, OutputKind::surface, ".json"};
  const std::string extension = extension_of(path);
  for (const Extension& e : kExtensions)
    if (extension == e.name) {
      if (e.kind == OutputKind::cad && !cad_available())
        throw InvalidInput(path + ": this knotfit was built without STEP and IGES");
      return {path, e.kind, extension};
    }
  for (const std::string_view later : kLater)
    if (extension == later)
      throw InvalidInput(fmt::format("{}: writing {} is not supported by this version; outputs are {}", path,
                                     extension, extensions()));
  throw InvalidInput(fmt::format("{}: {}; outputs are {}", path,
                                 extension.empty() ? "an output needs an extension"
                                                   : fmt::format("no output has the extension {}", extension),
                                 extensions()));
}

// The same file, by whatever name.
bool same_file(const std::string& a, const std::string& b) {
  if (is_dash(a) || is_dash(b)) return false;  // standard input is not standard output
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  return fs::path(a).lexically_normal() == fs::path(b).lexically_normal();
}

}  // namespace

std::vector<FormatInfo> all_formats() {
  std::vector<FormatInfo> all;
  for (FormatInfo format : formats()) {
    // Not a data format, but eval, info and convert read it.
    if (format.extensions.find(".json") != std::string_view::npos) format.reads = true;
    if (format.name == "step" || format.name == "iges") format.reads = format.writes = cad_available();
    all.push_back(format);
  }
  all.push_back({"picture", ".png .svg .pdf", "the surface with its knot lines and errors", false, true});
  return all;
}

std::vector<OutputFile> plan_outputs(const OutputOptions& output, const std::string& input) {
  std::vector<OutputFile> files;
  for (const std::string& path : output.paths) {
    for (const OutputFile& other : files)
      if (same_file(other.path, path)) throw InvalidInput(path + ": given twice as output");
    if (same_file(path, input)) throw InvalidInput(path + ": is the input; give another name for the output");
    files.push_back(classify(path));
  }
  for (const OutputFile& file : files)
    if (!is_dash(file.path)) check_writable(file.path, output.force);
  return files;
}

bool asks_for(const std::vector<OutputFile>& outputs, OutputKind kind) {
  for (const OutputFile& file : outputs)
    if (file.kind == kind) return true;
  return false;
}

Raster grid_over(const ParameterMap& map, std::pair<double, double> cell) {
  // The last centre may miss the far corner by rounding.
  const auto centres = [](double length, double step) { return std::floor(length / step + 1e-9) + 1; };
  const double columns = centres(map.u1 - map.u0, cell.first);
  const double rows = centres(map.v1 - map.v0, cell.second);
  if (!(columns * rows <= kMostCells))
    throw InvalidInput(fmt::format("--cell: {} x {} makes {} x {} cells; give a larger cell", cell.first,
                                   cell.second, columns, rows));
  Raster grid;
  grid.columns = static_cast<Index>(columns);
  grid.rows = static_cast<Index>(rows);
  grid.dx = cell.first;
  grid.dy = cell.second;
  grid.x0 = map.u0 - 0.5 * cell.first;
  grid.y0 = map.v0 - 0.5 * cell.second;
  return grid;
}

void fill_heights(Raster& grid, const Surface& surface, const ParameterMap& map) {
  if (map.sheared()) {
    std::vector<double> uv;
    uv.reserve(static_cast<std::size_t>(2 * grid.rows * grid.columns));
    for (Index r = 0; r < grid.rows; ++r)
      for (Index c = 0; c < grid.columns; ++c)
        for (const double x : map.to_uv(grid.x(c), grid.y(r))) uv.push_back(std::clamp(x, 0.0, 1.0));
    grid.z = evaluate(surface, uv);
    for (Index k = 0; k < grid.rows * grid.columns; ++k)
      if (const auto [u, v] = map.to_uv(grid.x(k % grid.columns), grid.y(k / grid.columns));
          !map.covers(u, v))
        grid.z[k] = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  std::vector<double> u(grid.columns), v(grid.rows);
  for (Index c = 0; c < grid.columns; ++c) u[c] = map.to_u(grid.x(c));
  for (Index r = 0; r < grid.rows; ++r) v[grid.rows - 1 - r] = map.to_v(grid.y(r));
  const std::vector<double> heights = evaluate_grid(surface, u, v);
  grid.z.resize(heights.size());
  for (Index r = 0; r < grid.rows; ++r)
    for (Index c = 0; c < grid.columns; ++c)
      grid.z[r * grid.columns + c] = heights[c * grid.rows + (grid.rows - 1 - r)];
}

void keep_holes(Raster& grid, const Raster& source) {
  const auto nearest = [](double at, double origin, double step, Index count) {
    return std::clamp<Index>(static_cast<Index>(std::floor((at - origin) / step)), 0, count - 1);
  };
  for (Index r = 0; r < grid.rows; ++r) {
    const Index from_south = nearest(grid.y(r), source.y0, source.dy, source.rows);
    const Index row = source.rows - 1 - from_south;
    for (Index c = 0; c < grid.columns; ++c) {
      const Index column = nearest(grid.x(c), source.x0, source.dx, source.columns);
      if (std::isnan(source.z[row * source.columns + column]))
        grid.z[r * grid.columns + c] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  grid.nodata = source.nodata;
}

double free_nodata(const Raster& raster) {
  double nodata = std::isfinite(raster.nodata) ? raster.nodata : -9999;
  const auto taken = [&] {
    for (const double z : raster.z)
      if (z == nodata) return true;
    return false;
  };
  if (taken()) nodata = -9999;
  while (taken()) nodata = nodata * 10 - 9;
  return nodata;
}

void write_raster_file(const std::string& path, bool force, Raster raster) {
  raster.nodata = free_nodata(raster);
  write_file(path, force, [&](std::ostream& out) { write_raster(out, raster); });
}

void write_text_file(const std::string& path, bool force, const std::string& text) {
  if (is_dash(path)) return print(text);
  write_file(path, force, [&](std::ostream& out) { out << text; });
}

void write_picture_file(const OutputFile& file, bool force, const PictureInput& picture) {
  write_text_file(file.path, force, draw_picture(picture, file.extension));
}

int write_each(const std::vector<OutputFile>& files, const std::function<void(const OutputFile&)>& write,
               std::vector<std::string>& written) {
  int status = kReached;
  const auto failed = [&](int with, const std::exception& e) {
    std::fprintf(stderr, "knotfit: %s\n", in_tool_words(e.what()).c_str());
    if (status == kReached || with == kOther) status = with;
  };
  for (const OutputFile& file : files) {
    try {
      write(file);
      written.push_back(file.path);
    } catch (const FileError& e) {
      failed(kBadInput, e);
    } catch (const InvalidInput& e) {
      failed(kBadInput, e);
    } catch (const WriteError& e) {
      failed(kOther, e);
    }
  }
  return status;
}

void print_summary(const std::string& text, const std::vector<OutputFile>& files) {
  for (const OutputFile& file : files)
    if (is_dash(file.path)) {
      std::fputs(text.c_str(), stderr);
      return;
    }
  print(text);
}

std::string wrote(const std::vector<std::string>& paths) {
  std::string text;
  for (const std::string& path : paths)
    if (!is_dash(path)) text += "wrote " + path + "\n";
  return text;
}

std::string wrote(const std::vector<OutputFile>& files) {
  std::vector<std::string> paths;
  paths.reserve(files.size());
  for (const OutputFile& file : files) paths.push_back(file.path);
  return wrote(paths);
}

void print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) throw WriteError("standard output", std::strerror(errno));
}

}  // namespace knotfit::tool
