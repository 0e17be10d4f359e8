#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "applicable_options.h"
#include "cad_output.h"
#include "commands.h"
#include "data_conversion.h"
#include "exit_status.h"
#include "input.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "mesh_outputs.h"
#include "outputs.h"
#include "sampling.h"
#include "standard_streams.h"
#include "surface_file.h"
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
  return fmt::format("{}: {} x {} control points, degree {} x {}",
                     std::filesystem::path(path).filename().string(), s.size_u(), s.size_v(), s.degree_u(),
                     s.degree_v());
}

void convert_surface(const Arguments& arguments, const std::vector<OutputFile>& files) {
  refuse_data_options(arguments.choices.input.given, "a surface: it says how data is read");
  std::vector<std::string> given = arguments.choices.input.given;
  if (is_cad_file(arguments.input)) std::erase(given, "--unit");  // that of the input
  refuse_idle_output_options(given, files);
  const SurfaceDocument document =
      read_one_surface(arguments.input, {.unit = arguments.choices.cad.unit, .face = arguments.source.face});
  const bool force = arguments.output.force;
  for (const OutputFile& file : files) {
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
        picture.title = picture_title(document, arguments.input);
        write_picture_file(file, force, picture);
        break;
      }
    }
  }
}

// Data has no JSON: standard output gets its points.
/// \return what was done with the input, for the summary
std::string convert_data(const Arguments& arguments, std::vector<OutputFile> files) {
  for (OutputFile& file : files)
    if (is_dash(file.path)) file.kind = OutputKind::table;
  refuse_given(arguments.choices.input.given,
               {"--face", "--cell", "--samples", "--reflections", "--grid", "--unit", "--name",
                "--step-schema", "--cad-safe", "--cad-tol"},
               "data: it is for surfaces");
  for (const OutputFile& file : files)
    if (file.kind == OutputKind::surface || file.kind == OutputKind::picture || file.kind == OutputKind::cad)
      throw InvalidInput(fmt::format(
          "{}: data becomes .csv, .asc or .grd, and a mesh .obj or .ply; a {} needs a surface: knotfit fit",
          file.path, file.extension));
  InputOptions options = arguments.choices.input;
  options.keep_parameters = true;
  const SourceData data = read_input(arguments.input, options);
  const Mesh* mesh = std::get_if<Mesh>(&data.content);
  for (const OutputFile& file : files)
    if (file.kind == OutputKind::mesh && mesh == nullptr)
      throw InvalidInput(fmt::format("{}: a {} holds a mesh or a surface, and {} holds neither", file.path,
                                     file.extension, input_name(arguments.input)));
  for (const OutputFile& file : files) {
    if (file.kind == OutputKind::mesh)
      write_mesh_file(file, arguments.output.force, *mesh);
    else if (file.kind == OutputKind::raster)
      write_raster_file(file.path, arguments.output.force, raster_of(data));
    else
      write_text_file(file.path, arguments.output.force, to_csv(points_table(data)));
  }
  const Reading reading = reading_of(data);
  return columns_to_text(reading) + notes_to_text(reading);
}

}  // namespace

int run_convert(const Arguments& arguments) {
  const std::vector<OutputFile> files = plan_outputs(arguments.output, arguments.input);
  std::string text;
  if (holds_surfaces(arguments.input, arguments.choices.input))
    convert_surface(arguments, files);
  else
    text = convert_data(arguments, files);
  print_summary(text + wrote(files), files);
  return kReached;
}

}  // namespace knotfit::tool
