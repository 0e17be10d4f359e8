#include <fmt/format.h>

#include "applicable_options.h"
#include "commands.h"
#include "convert_surface.h"
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

void convert_surface(const Arguments& arguments, const std::vector<OutputFile>& files) {
  refuse_data_options(arguments.choices.input.given, "a surface: it says how data is read");
  std::vector<std::string> given = arguments.choices.input.given;
  if (is_cad_file(arguments.input)) std::erase(given, "--unit");  // that of the input
  refuse_idle_output_options(given, files);
  const SurfaceDocument document =
      read_one_surface(arguments.input, {.unit = arguments.choices.cad.unit, .face = arguments.source.face});
  for (const OutputFile& file : files)
    write_converted(file, arguments.output.force, document, arguments, arguments.input);
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
