#include "formats/foreign.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

using namespace std::string_view_literals;

// The command that converts a kind of file; IN and OUT (without an extension) stand for the names.
constexpr std::string_view kRaster = "gdal_translate -of AAIGrid IN OUT.asc";
constexpr std::string_view kCloud = "pdal translate IN OUT.las";
constexpr std::string_view kMesh = "assimp export IN OUT.obj";
constexpr std::string_view kSheet = "libreoffice --headless --convert-to csv IN";
constexpr std::string_view kVtk = "meshio convert IN OUT.ply";
constexpr std::string_view kArrays =
    "python3 -c \"import numpy; a = numpy.load('IN'); numpy.save('OUT.npy', a[a.files[0]])\" (its first "
    "array)";

struct Magic {
  std::string_view bytes;
  const char* what;
  std::string_view command;
};
constexpr Magic kMagics[] = {
    {"II*\0"sv, "a GeoTIFF raster", kRaster},
    {"MM\0*"sv, "a GeoTIFF raster", kRaster},
    {"II+\0"sv, "a GeoTIFF raster", kRaster},
    {"MM\0+"sv, "a GeoTIFF raster", kRaster},
    {"\x89HDF\r\n\x1A\n"sv, "a netCDF grid (HDF5)", kRaster},
    {"CDF\x01"sv, "a netCDF grid", kRaster},
    {"CDF\x02"sv, "a netCDF grid", kRaster},
    {"CDF\x05"sv, "a netCDF grid", kRaster},
    {"DSAA"sv, "a Surfer grid", kRaster},
    {"DSBB"sv, "a Surfer grid", kRaster},
    {"DSRB"sv, "a Surfer grid", kRaster},
    {"EHFA_HEADER_TAG"sv, "an ERDAS raster", kRaster},
    {"SQLite format 3\0"sv, "a GeoPackage (SQLite)", kRaster},
    {"\0\0\0\x0CjP  "sv, "a JPEG 2000 raster", kRaster},
    {"ASTM-E57"sv, "an E57 point cloud", kCloud},
    {"glTF"sv, "a glTF model", kMesh},
    {"Kaydara FBX Binary"sv, "an FBX model", kMesh},
    {"BLENDER-v"sv, "a Blender model", kMesh},
    {"BLENDER_v"sv, "a Blender model", kMesh},
    {"# vtk DataFile"sv, "a VTK file", kVtk},
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv, "a spreadsheet (XLS)", kSheet},
    {"\x1F\x8B"sv, "a gzip file", "gunzip -k IN"},
    {"BZh91AY"sv, "a bzip2 file", "bunzip2 -k IN"},
    {"\xFD"
     "7zXZ\0"sv,
     "an xz file", "unxz -k IN"},
    {"\x28\xB5\x2F\xFD"sv, "a Zstandard file", "unzstd IN"},
    {"7z\xBC\xAF\x27\x1C"sv, "a 7z archive", "7z x IN"},
    {"Rar!\x1A\x07"sv, "a RAR archive", "7z x IN"},
};

struct Extension {
  std::string_view names;
  const char* what;
  std::string_view command;
};
constexpr Extension kExtensions[] = {
    {" .tif .tiff ", "a GeoTIFF raster", kRaster},
    {" .img .dem .hgt .bil .flt .adf .nc .gpkg .jp2 .vrt .ecw .kea ", "a raster of a format", kRaster},
    {" .laz .copc ", "a compressed point cloud (LAZ)", kCloud},
    {" .e57 .bpf .rxp ", "a point cloud of a format", kCloud},
    {" .gltf .glb ", "a glTF model", kMesh},
    {" .3mf ", "a 3MF model", kMesh},
    {" .fbx .dae .blend .x3d .wrl .3ds .dxf .ac .lwo ", "a model of a format", kMesh},
    {" .vtk .vtp .vtu ", "a VTK file", kVtk},
    {" .msh .inp .med .xdmf ", "a mesh of a format", kVtk},
    {" .xls .xlsx .ods ", "a spreadsheet", kSheet},
    {" .npz ", "an archive of NumPy arrays (.npz)", kArrays},
    {" .zip ", "a ZIP archive", "unzip IN"},
    {" .gz .bz2 .xz .zst .7z .rar ", "a compressed file", "7z x IN"},
};

bool harmless(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("/._-+=,@%:").find(c) != std::string_view::npos;
}

// As a shell takes it.
std::string quoted(const std::string& name) {
  if (!name.empty() && name.front() != '-' && std::all_of(name.begin(), name.end(), harmless)) return name;
  std::string text = "'";
  for (const char c : name) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

void replace(std::string& text, std::string_view from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

std::string sentence(std::string_view what, std::string_view command, const std::string& where) {
  const std::string path =
      where == "standard input" ? "FILE" : where;  // what came through a pipe has no name
  const std::filesystem::path file(path);
  std::string out = (file.parent_path() / file.stem()).string();
  std::string text(command);
  // Never over the file itself: a LAZ file may be called .las, a Surfer grid .asc.
  if (const std::size_t at = text.find("OUT"); at != std::string::npos)
    if (out + text.substr(at + 3, text.find_first_of(" '", at) - at - 3) == path) out += "_converted";
  if (text.find("'IN'") != std::string::npos) {  // in quotes already
    replace(text, "IN", path);
    replace(text, "OUT", out);
  } else {
    const std::size_t at = text.find("OUT");
    if (at != std::string::npos) {
      const std::size_t end = std::min(text.find(' ', at), text.size());
      text.replace(at, end - at, quoted(out + text.substr(at + 3, end - at - 3)));
    }
    if (const std::size_t in = text.find("IN"); in != std::string::npos) text.replace(in, 2, quoted(path));
  }
  return fmt::format("is {}, which this version does not read; convert it: {}", what, text);
}

// ZIP keeps the names of its members as they are.
std::string archive(std::string_view bytes, const std::string& path) {
  const auto holds = [bytes](std::string_view name) { return bytes.find(name) != std::string_view::npos; };
  if (holds("3D/3dmodel.model")) return sentence("a 3MF model", kMesh, path);
  if (holds("xl/workbook")) return sentence("a spreadsheet (XLSX)", kSheet, path);
  if (holds("vnd.oasis.opendocument.spreadsheet")) return sentence("a spreadsheet (ODS)", kSheet, path);
  if (holds(".npy")) return sentence("an archive of NumPy arrays (.npz)", kArrays, path);
  const std::string by_name = foreign_extension(path);
  return by_name.empty() ? sentence("a ZIP archive", "unzip IN", path) : by_name;
}

bool is_gltf_text(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || bytes[first] != '{') return false;
  const auto holds = [bytes](std::string_view name) { return bytes.find(name) != std::string_view::npos; };
  return holds("\"asset\"") &&
         (holds("\"meshes\"") || holds("\"accessors\"") || holds("\"buffers\"") || holds("\"nodes\""));
}

}  // namespace

std::string foreign_file(std::string_view bytes, const std::string& path) {
  if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06")) return archive(bytes, path);
  if (bytes.starts_with("LASF") && bytes.size() > 104 && static_cast<unsigned char>(bytes[104]) >= 64)
    return sentence("a compressed point cloud (LAZ)", kCloud, path);
  for (const Magic& magic : kMagics)
    if (bytes.starts_with(magic.bytes)) return sentence(magic.what, magic.command, path);
  const std::string_view head = bytes.substr(0, kForeignBytes);
  if (is_gltf_text(head)) return sentence("a glTF model", kMesh, path);
  if (head.starts_with("<") && head.find("<VTKFile") != std::string_view::npos)
    return sentence("a VTK file", kVtk, path);
  return "";
}

std::string foreign_extension(const std::string& path) {
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  if (extension.empty()) return "";
  for (const Extension& e : kExtensions)
    if (e.names.find(" " + extension + " ") != std::string_view::npos) {
      std::string what = e.what;
      if (what.ends_with("format")) what += " (" + extension + ")";
      return sentence(what, e.command, path);
    }
  return "";
}

void refuse_foreign(const FileBytes& file) {
  if (const std::string why = foreign_file(file.view(), file.path()); !why.empty())
    throw FileError(file.path(), why);
}

}  // namespace knotfit
