#include "targets.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "formats/file_bytes.h"
#include "formats/readers.h"
#include "knotfit/curve_io.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/mesh.h"
namespace knotfit::fuzz {
namespace {

void require(bool promise, const char* what) {
  if (!promise) throw std::logic_error(what);
}

void require_finite(const std::vector<double>& values, const char* what) {
  for (const double x : values) require(std::isfinite(x), what);
}

void check(const PointTable& t) {
  const std::size_t n = t.z.size();
  require(n > 0, "a table without points");
  for (const auto* column : {&t.x, &t.y, &t.u, &t.v, &t.weight, &t.nx, &t.ny, &t.nz})
    require(column->empty() || column->size() == n, "columns of different lengths");
  for (const auto* column : {&t.x, &t.y, &t.u, &t.v, &t.weight})
    require_finite(*column, "a coordinate is not finite");
  require(t.line.empty() || t.line.size() == n, "lines of other points");
}

void check(const PointRows& rows) {
  require(rows.xyz.size() % 3 == 0 && rows.size() > 0, "rows without points");
  require(!rows.row_start.empty() && rows.row_start.front() == 0 && rows.row_start.back() == rows.size(),
          "rows that are not the points");
  for (std::size_t r = 1; r < rows.row_start.size(); ++r)
    require(rows.row_start[r] >= rows.row_start[r - 1], "a row that ends before it begins");
  for (const double x : rows.xyz) require(!std::isinf(x), "a coordinate is infinite");
}

void check(const Raster& r) {
  require(r.columns > 0 && r.rows > 0 && r.z.size() == static_cast<std::size_t>(r.columns * r.rows),
          "a raster of other cells than its size");
  require(r.dx > 0 && r.dy > 0 && std::isfinite(r.dx + r.dy + r.x0 + r.y0), "cells without a size or place");
  for (const double z : r.z) require(!std::isinf(z), "a height is infinite");
}

void check(const Mesh& m) {
  require(m.face_count() > 0 && m.vertices.size() % 3 == 0, "a mesh without faces");
  require_finite(m.vertices, "a vertex is not finite");
  require_finite(m.uv, "a parameter is not finite");
  require(m.uv.empty() || m.uv.size() == 2 * static_cast<std::size_t>(m.vertex_count()),
          "parameters of other vertices");
  for (const auto& face : m.faces)
    for (const std::int32_t v : face) require(v >= 0 && v < m.vertex_count(), "a corner that is no vertex");
  inspect(m);
}

// Reads as the tool does; what is refused is refused by an error of the file.
bool read(const std::string& name, std::string_view bytes, const ReadOptions& options) {
  try {
    const SourceData data = read_bytes(FileBytes(name, bytes), options);
    if (!options.places) std::visit([](const auto& content) { check(content); }, data.content);
    return true;
  } catch (const FileError& e) {
    require(std::string_view(e.what()).starts_with(name), "an error that does not name its file");
    require(std::string_view(e.what()).size() < 4000, "an error longer than a screen");
  }
  return false;
}

template <const char* format>
bool read_format(std::string_view bytes) {
  ReadOptions options;
  options.format = format;
  return read("file", bytes, options);
}

// Text of points: a table, rows, or a grid by its content; and as places, which may lack a z.
bool read_text(std::string_view bytes) {
  ReadOptions places;
  places.places = true;
  const bool as_places = read("file.txt", bytes, places);
  return read("file.txt", bytes, {}) || as_places;
}

// Whatever the content tells.
bool read_unnamed(std::string_view bytes) {
  return read("file", bytes, {});
}

// What is read is written, and reads back as the same.
bool read_surface_json(std::string_view bytes) {
  SurfaceDocument document;
  try {
    document = surface_from_json(bytes, "file");
  } catch (const FileError& e) {
    require(std::string_view(e.what()).starts_with("file"), "an error that does not name its file");
    return false;
  }
  require_finite(document.surface.net(), "a control point is not finite");
  const SurfaceDocument again = surface_from_json(to_json(document), "again");
  require(again.surface.net() == document.surface.net() &&
              again.surface.knots_u().knots() == document.surface.knots_u().knots() &&
              again.surface.knots_v().knots() == document.surface.knots_v().knots(),
          "a surface that reads back as another");
  return true;
}

bool read_curve_json(std::string_view bytes) {
  CurveDocument document;
  try {
    document = curve_from_json(bytes, "file");
  } catch (const FileError& e) {
    require(std::string_view(e.what()).starts_with("file"), "an error that does not name its file");
    return false;
  }
  require_finite(document.curve.control_points(), "a control point is not finite");
  const CurveDocument again = curve_from_json(to_json(document), "again");
  require(again.curve.control_points() == document.curve.control_points() &&
              again.curve.knots().knots() == document.curve.knots().knots(),
          "a curve that reads back as another");
  return true;
}

constexpr char kGrid[] = "esri-ascii", kCsv[] = "csv", kRows[] = "rows", kNpy[] = "npy",
               kNpyGrid[] = "npy-grid", kPly[] = "ply", kObj[] = "obj", kOff[] = "off", kStl[] = "stl",
               kLas[] = "las", kPcd[] = "pcd";

constexpr std::array kTargets = {
    Target{kGrid, read_format<kGrid>},         Target{kCsv, read_format<kCsv>},
    Target{kRows, read_format<kRows>},         Target{"text", read_text},
    Target{kNpy, read_format<kNpy>},           Target{kNpyGrid, read_format<kNpyGrid>},
    Target{kPly, read_format<kPly>},           Target{kObj, read_format<kObj>},
    Target{kOff, read_format<kOff>},           Target{kStl, read_format<kStl>},
    Target{kLas, read_format<kLas>},           Target{kPcd, read_format<kPcd>},
    Target{"surface-json", read_surface_json}, Target{"curve-json", read_curve_json},
    Target{"unnamed", read_unnamed},
};

}  // namespace

std::span<const Target> targets() {
  return kTargets;
}

const Target* find_target(std::string_view name) {
  for (const Target& target : kTargets)
    if (target.name == name) return &target;
  return nullptr;
}

}  // namespace knotfit::fuzz
