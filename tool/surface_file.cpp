#include "surface_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "formats/json_document.h"
#include "knotfit/cad.h"
#include "knotfit/exceptions.h"
#include "standard_streams.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

constexpr std::string_view kJson = "knotfit-json";

bool is_cad_format(std::string_view name) {
  return name == "step" || name == "iges";
}

KnotVector on_unit(const KnotVector& knots) {
  const double first = knots.first(), last = knots.last();
  if (first == 0 && last == 1) return knots;
  std::vector<double> moved;
  for (const double t : knots.knots()) moved.push_back(t == last ? 1 : (t - first) / (last - first));
  return KnotVector(knots.degree(), std::move(moved));
}

SurfaceDocument read_json_surface(const std::string& path) {
  if (!is_dash(path)) return read_surface(path);
  const FileBytes bytes = standard_input();
  return surface_from_json(bytes.view(), bytes.path());
}

// Parameters of the file's own, with those of the surface in [0,1].
SurfaceDocument with_unit_domain(SurfaceDocument document) {
  const Surface& s = document.surface;
  const auto unit = [](const KnotVector& k) { return k.first() == 0 && k.last() == 1; };
  if ((unit(s.knots_u()) && unit(s.knots_v())) || !(document.map == ParameterMap{})) return document;
  document.map.u0 = s.knots_u().first();
  document.map.u1 = s.knots_u().last();
  document.map.v0 = s.knots_v().first();
  document.map.v1 = s.knots_v().last();
  document.surface = Surface(on_unit(s.knots_u()), on_unit(s.knots_v()), s.dimension(), s.net());
  return document;
}

}  // namespace

bool is_cad_file(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".step" || extension == ".stp" || extension == ".igs" || extension == ".iges";
}

bool holds_surfaces(const std::string& path, const InputOptions& options) {
  if (options.format)
    return *options.format == kJson || (is_cad_file(path) && is_cad_format(*options.format));
  if (!is_dash(path)) return extension_of(path) == ".json" || is_cad_file(path);
  const FileBytes bytes = standard_input();
  const std::size_t first = without_mark(bytes.view()).find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && without_mark(bytes.view())[first] == '{';
}

void refuse_idle_surface_options(const std::string& path, const SurfaceChoices& choices) {
  if (choices.unit && !is_cad_file(path))
    throw InvalidInput(input_name(path) +
                       ": --unit does not apply to a JSON surface: it is the unit of STEP and IGES files");
}

std::vector<FileFace> read_faces(const std::string& path, const SurfaceChoices& choices) {
  std::vector<FileFace> faces;
  if (!is_cad_file(path)) {
    faces.push_back({with_unit_domain(read_json_surface(path)), "B-spline surface", "", false});
    return faces;
  }
  for (CadFace& face : read_cad_faces(path, choices.unit.value_or(CadUnit::millimetre))) {
    FileFace& added = faces.emplace_back();
    added.kind = std::move(face.kind);
    added.why = std::move(face.why);
    added.trimmed = face.trimmed;
    if (!face.surface) continue;
    added.document.emplace();
    added.document->surface = std::move(*face.surface);
    added.document = with_unit_domain(std::move(*added.document));
  }
  return faces;
}

SurfaceDocument read_one_surface(const std::string& path, const SurfaceChoices& choices) {
  std::vector<FileFace> faces = read_faces(path, choices);
  const std::size_t count = faces.size();
  std::vector<std::size_t> usable;
  for (std::size_t k = 0; k < count; ++k)
    if (faces[k].document) usable.push_back(k + 1);
  if (!choices.face && usable.size() == 1) return std::move(*faces[usable[0] - 1].document);
  if (!choices.face && usable.size() == count)
    throw InvalidInput(
        fmt::format("{}: holds {} surfaces; choose one with --face 1 to {}", input_name(path), count, count));
  if (!choices.face && usable.size() > 1)
    throw InvalidInput(fmt::format(
        "{}: holds {} faces, of which {} are usable; choose one with --face {}{} (knotfit info lists them)",
        input_name(path), count, usable.size(),
        fmt::join(usable.begin(), usable.begin() + std::min<Index>(8, std::ssize(usable)), ", "),
        usable.size() > 8 ? ", ..." : ""));
  if (!choices.face) {
    std::string why;
    for (std::size_t k = 0; k < count && k < 4; ++k)
      why += fmt::format("{}face {} is a {}: {}", k == 0 ? "" : "; ", k + 1, faces[k].kind, faces[k].why);
    throw InvalidInput(fmt::format("{}: holds {} face{}, and no surface that is usable: {}{}",
                                   input_name(path), count, count == 1 ? "" : "s", why,
                                   count > 4 ? "; ..." : ""));
  }
  const auto face = static_cast<std::size_t>(*choices.face);
  if (face > count)
    throw InvalidInput(fmt::format("{}: --face {}: there {} {} surface{}", input_name(path), face,
                                   count == 1 ? "is" : "are", count, count == 1 ? "" : "s"));
  if (!faces[face - 1].document) {
    std::string others;
    if (!usable.empty()) others = fmt::format("; --face {} is usable", usable[0]);
    throw InvalidInput(fmt::format("{}: --face {}: the face is a {}: {}{}", input_name(path), face,
                                   faces[face - 1].kind, faces[face - 1].why, others));
  }
  return std::move(*faces[face - 1].document);
}

Surface surface_in_space(const SurfaceDocument& document, const std::string& otherwise) {
  if (document.surface.dimension() == 3) return document.surface;
  if (document.height_field) return height_field_in_space(document.surface, document.map);
  throw InvalidInput(otherwise);
}

}  // namespace knotfit::tool
