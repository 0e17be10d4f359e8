#include "surface_file.h"

#include <fmt/format.h>

#include "formats/json_document.h"
#include "knotfit/cad.h"
#include "knotfit/errors.h"
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

std::vector<SurfaceDocument> read_surfaces(const std::string& path, const SurfaceChoices& choices) {
  std::vector<SurfaceDocument> documents;
  if (is_cad_file(path)) {
    for (Surface& surface : read_cad(path, choices.unit.value_or(CadUnit::millimetre))) {
      SurfaceDocument document;
      document.surface = std::move(surface);
      documents.push_back(with_unit_domain(std::move(document)));
    }
  } else if (is_dash(path)) {
    const FileBytes bytes = standard_input();
    documents.push_back(with_unit_domain(surface_from_json(bytes.view(), bytes.path())));
  } else {
    documents.push_back(with_unit_domain(read_surface(path)));
  }
  return documents;
}

SurfaceDocument read_one_surface(const std::string& path, const SurfaceChoices& choices) {
  std::vector<SurfaceDocument> documents = read_surfaces(path, choices);
  const std::size_t count = documents.size();
  if (!choices.face && count > 1)
    throw InvalidInput(
        fmt::format("{}: holds {} surfaces; choose one with --face 1 to {}", input_name(path), count, count));
  const auto face = static_cast<std::size_t>(choices.face.value_or(1));
  if (face > count)
    throw InvalidInput(fmt::format("{}: --face {}: there {} {} surface{}", input_name(path), face,
                                   count == 1 ? "is" : "are", count, count == 1 ? "" : "s"));
  return std::move(documents[face - 1]);
}

Surface surface_in_space(const SurfaceDocument& document, const std::string& otherwise) {
  if (document.surface.dimension() == 3) return document.surface;
  if (document.height_field) return height_field_in_space(document.surface, document.map);
  throw InvalidInput(otherwise);
}

}  // namespace knotfit::tool
