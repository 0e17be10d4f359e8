#include "convert_surface.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cad_output.h"
#include "knotfit/exceptions.h"
#include "mesh_outputs.h"
#include "sampling.h"
namespace knotfit::tool {
namespace {

using Json = nlohmann::ordered_json;

// The grid of the raster that was fitted, as the surface file tells it: {} where there was none.
std::optional<Raster> fitted_grid(const SurfaceDocument& document) {
  const Json result = Json::parse(document.result, nullptr, false);
  if (!result.is_object() || !result.contains("input")) return std::nullopt;
  const Json& input = result["input"];
  if (!input.is_object() || !input.contains("grid") || !input["grid"].is_object()) return std::nullopt;
  try {
    const Json& grid = input["grid"];
    Raster raster;
    raster.columns = grid.at("columns").get<Index>();
    raster.rows = grid.at("rows").get<Index>();
    raster.x0 = grid.at("x0").get<double>();
    raster.y0 = grid.at("y0").get<double>();
    raster.dx = grid.at("dx").get<double>();
    raster.dy = grid.at("dy").get<double>();
    const bool sound = raster.columns > 0 && raster.rows > 0 && raster.dx > 0 && raster.dy > 0 &&
                       raster.columns <= 400'000'000 / raster.rows;
    return sound ? std::optional(raster) : std::nullopt;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

Raster heights(const SurfaceDocument& document, const Arguments& arguments, const std::string& path) {
  if (!document.height_field)
    throw InvalidInput(path + ": holds heights over x, y, but the surface is not a height field");
  std::optional<Raster> grid;
  if (arguments.choices.cell)
    grid = grid_over(document.map, *arguments.choices.cell);
  else
    grid = fitted_grid(document);
  if (!grid) throw InvalidInput(path + ": needs --cell SIZE, since the surface was not fitted to a raster");
  fill_heights(*grid, document.surface, document.map);
  return *grid;
}

std::string picture_title(const SurfaceDocument& document, const std::string& path) {
  const Surface& s = document.surface;
  const std::string name = path.empty() ? "" : std::filesystem::path(path).filename().string() + ": ";
  return fmt::format("{}{} x {} control points, degree {} x {}", name, s.size_u(), s.size_v(), s.degree_u(),
                     s.degree_v());
}

}  // namespace

void write_converted(const OutputFile& file, bool force, const SurfaceDocument& document,
                     const Arguments& arguments, const std::string& name) {
  switch (file.kind) {
    case OutputKind::surface:
      write_text_file(file.path, force, to_json(document));
      break;
    case OutputKind::table: {
      const Places places = grid_places(document.map, arguments.grid.value_or(kConvertGrid));
      write_text_file(file.path, force,
                      to_csv(sample(document, places, parameters_of(places, document.map, true), {})));
      break;
    }
    case OutputKind::raster:
      write_raster_file(file.path, force, heights(document, arguments, file.path));
      break;
    case OutputKind::mesh:
      write_surface_mesh(file, force, document.surface, document.map, document.height_field,
                         arguments.choices.samples.value_or(kSamplesPerSpan), nullptr, {});
      break;
    case OutputKind::cad:
      write_cad_file(file, force, document.surface, document.map, document.height_field,
                     arguments.choices.cad);
      break;
    case OutputKind::picture: {
      PictureInput picture;
      picture.surface = &document.surface;
      picture.reflections = arguments.reflections;
      picture.title = picture_title(document, name);
      write_picture_file(file, force, picture);
      break;
    }
  }
}

}  // namespace knotfit::tool
