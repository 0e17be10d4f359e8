// Which formats there are, and which one a file has.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <new>
#include <stdexcept>

#include "formats/foreign.h"
#include "formats/npy_header.h"
#include "formats/readers.h"
#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/remedy.h"
namespace knotfit {
namespace {

struct Format {
  FormatInfo info;
  SourceData (*read)(const FileBytes&, const ReadOptions&);  ///< null: no data is read from it
};

// Written out, not filled by static constructors: a static library drops objects nobody names.
constexpr std::array kFormats = {
    Format{{"esri-ascii", ".asc .grd", "ESRI ASCII grid of heights", true, true}, read_esri_ascii},
    Format{{"csv", ".csv .tsv .txt .xyz .pts .dat", "points, a line each: x,y,z, x,y,z,u,v or named columns",
            true, true},
           read_csv},
    Format{{"rows", ".rows",
            "rows of points x y z, a blank line between rows (.txt, .xyz, .pts and .dat too)", true, false},
           read_rows},
    Format{
        {"npy", ".npy", "NumPy array: n x 3 to n x 9 points, H x W heights, H x W x 3 points", true, false},
        read_npy},
    Format{{"npy-grid", "", "NumPy array H x W of heights, also where W is 9 or less", true, false},
           read_npy},
    Format{{"ply", ".ply", "mesh or points, text or binary; x, y, z and s, t or u, v", true, true}, read_ply},
    Format{{"obj", ".obj", "Wavefront mesh: v, vt, polygons", true, true}, read_obj},
    Format{{"off", ".off", "mesh: vertices and polygons in text", true, false}, read_off},
    Format{{"stl", ".stl", "triangles, text or binary; equal corners become one vertex", true, false},
           read_stl},
    Format{{"las", ".las", "points of a laser scanner, with classes and returns", true, false}, read_las},
    Format{{"pcd", ".pcd", "points or a grid of points of the Point Cloud Library", true, false}, read_pcd},
    Format{
        {"vtk", ".vts", "VTK structured grid of the surface, with error, normal and curvature", false, true},
        nullptr},
    // Read and written by cad.h, where it is built in.
    Format{{"step", ".step .stp", "B-spline surfaces for CAD (AP214, AP242)", false, false}, nullptr},
    Format{{"iges", ".igs .iges", "B-spline surfaces for CAD", false, false}, nullptr},
    Format{{"knotfit-json", ".json", "a knotfit surface", false, true}, nullptr},
};

constexpr std::array<FormatInfo, kFormats.size()> infos() {
  std::array<FormatInfo, kFormats.size()> out{};
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = kFormats[k].info;
  return out;
}
constexpr std::array kInfos = infos();

/// Extension of the last part of a path, in lower case with its dot; empty: none.
std::string extension_of(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

bool lists(std::string_view list, std::string_view word) {
  if (word.empty()) return false;
  for (std::size_t at = list.find(word); at != std::string_view::npos; at = list.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' ')) return true;
  }
  return false;
}

std::string readable() {
  std::string out;
  for (const Format& format : kFormats) {
    if (format.read == nullptr) continue;
    out += (out.empty() ? "" : ", ") + std::string(format.info.name);
    if (!format.info.extensions.empty()) out += fmt::format(" ({})", format.info.extensions);
  }
  return out;
}

const Format* by_name(std::string_view name) {
  for (const Format& format : kFormats)
    if (format.info.name == name) return &format;
  return nullptr;
}

const Format* by_extension(std::string_view extension) {
  for (const Format& format : kFormats)
    if (lists(format.info.extensions, extension)) return &format;
  return nullptr;
}

const Format* by_content(std::string_view bytes) {
  if (bytes.starts_with(kNpyMagic)) return by_name("npy");
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return by_name("ply");
  if (bytes.starts_with("OFF") || bytes.starts_with("off ") || bytes.starts_with("off\n") ||
      bytes.starts_with("off\r"))
    return by_name("off");
  if (bytes.starts_with("LASF")) return by_name("las");
  if (bytes.starts_with("# .PCD")) return by_name("pcd");
  return looks_like_esri_ascii(bytes) ? by_name("esri-ascii") : nullptr;
}

/// What can be said before the file is opened: an unknown format name.
void check_format_name(const ReadOptions& options) {
  if (options.format.empty()) return;
  const Format* format = by_name(options.format);
  if (format == nullptr || format->read == nullptr)
    throw InvalidInput(fmt::format("unknown input format \"{}\"; there are {}", options.format, readable()));
}

/// By the extension, where neither a format is named nor the bytes tell one that is read.
void refuse_foreign_extension(const FileBytes& file, const ReadOptions& options) {
  if (!options.format.empty() || by_content(file.view()) != nullptr) return;
  if (const std::string why = foreign_extension(file.path()); !why.empty()) throw FileError(file.path(), why);
}

/// By its first bytes: a raster of some gigabytes need not be read first. Archives are told by all of their bytes.
void refuse_foreign_beginning(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return;
  std::ifstream in(path, std::ios::binary);
  std::string head(kForeignBytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  if (head.starts_with("PK")) return;
  if (const std::string why = foreign_file(head, path); !why.empty()) throw FileError(path, why);
}

void check_filters(const FileBytes& file, const Format& format, const ReadOptions& options) {
  if (format.read != read_las && !(options.classes.empty() && options.returns.empty()))
    throw InvalidInput(
        fmt::format("{}: classes and returns ({}, {}) are asked for, but only LAS files have them",
                    file.path(), remedy_text(Remedy::classes), remedy_text(Remedy::returns)));
}

SourceData read_as(const FileBytes& file, const ReadOptions& options) {
  refuse_foreign(file);
  if (!options.format.empty()) {
    check_filters(file, *by_name(options.format), options);
    return by_name(options.format)->read(file, options);
  }
  refuse_foreign_extension(file, options);
  const std::string extension = extension_of(file.path());
  const Format* format = by_extension(extension);
  if (format == nullptr) format = by_content(file.view());
  if (format == nullptr)
    throw FileError(
        file.path(),
        fmt::format("{}; name the format with {}: {}",
                    extension.empty() ? std::string("a name without an extension does not tell the format")
                                      : "unknown extension " + extension,
                    remedy_text(Remedy::format), readable()));
  if (format->read == nullptr)
    throw FileError(file.path(), fmt::format("{} holds {}, not points; data is read from {}", extension,
                                             format->info.summary, readable()));
  check_filters(file, *format, options);
  if (format->read == read_csv && extension != ".csv" && extension != ".tsv")
    return looks_like_esri_ascii(file.view()) ? read_esri_ascii(file, options)
                                              : read_text_points(file, options);
  return format->read(file, options);
}

}  // namespace

std::span<const FormatInfo> formats() {
  return kInfos;
}

SourceData read_bytes(const FileBytes& file, const ReadOptions& options) {
  check_format_name(options);
  try {
    return read_as(file, options);
  } catch (const std::bad_alloc&) {
    throw FileError(file.path(), "reading it needs more memory than there is");
  } catch (const std::length_error&) {
    throw FileError(file.path(), "reading it needs more memory than there is");
  }
}

SourceData read_data(const std::string& path, const ReadOptions& options) {
  check_format_name(options);
  refuse_foreign_beginning(path);
  FileBytes file;
  try {
    file = load_file(path);
  } catch (const std::bad_alloc&) {
    throw FileError(path, "reading it needs more memory than there is");
  }
  return read_bytes(file, options);
}

}  // namespace knotfit
