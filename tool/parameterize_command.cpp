#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "applicable_options.h"
#include "commands.h"
#include "exit_status.h"
#include "input.h"
#include "knotfit/exceptions.h"
#include "knotfit/map_picture.h"
#include "knotfit/threads.h"
#include "mesh_input.h"
#include "mesh_outputs.h"
#include "options_json.h"
#include "outputs.h"
#include "sampling.h"
#include "signals.h"
#include "standard_streams.h"
#include "terminal_progress.h"
namespace knotfit::tool {
namespace {

std::string vertices_csv(const Mesh& mesh) {
  PointTable points = table_of(mesh);
  Table table;
  table.add("x", std::move(points.x));
  table.add("y", std::move(points.y));
  table.add("z", std::move(points.z));
  table.add("u", std::move(points.u));
  table.add("v", std::move(points.v));
  return to_csv(table);
}

void check_outputs(const std::vector<OutputFile>& files) {
  for (const OutputFile& file : files)
    if ((file.kind != OutputKind::table && file.kind != OutputKind::mesh &&
         file.kind != OutputKind::picture) ||
        file.extension == ".vts")
      throw InvalidInput(fmt::format(
          "{}: a mesh with parameters becomes .csv, .obj or .ply, a picture of its lines .png, .svg "
          "or .pdf",
          file.path));
}

// The mesh the map is linear on, with its lines.
std::string picture_of(const MappedMesh& mapped, const Arguments& arguments, const std::string& extension) {
  const MeshMap& map = *mapped.map;
  const Mesh halved = halve_edges(mapped.mesh, map.halved_edges);
  const std::vector<double> uv = map.all_uv();
  MapPictureInput picture;
  picture.mesh = &halved;
  picture.uv = &uv;
  picture.corners = map.corners;
  picture.parts = arguments.lines;
  picture.title = std::filesystem::path(arguments.input).filename().string();
  picture.subtitle = arguments.newton ? fmt::format("map of little stretch, normals weighted {:g}", map.omega)
                                      : fmt::format("mean value map, normals weighted {:g}", map.omega);
  return draw_map_picture(picture, extension);
}

}  // namespace

int run_parameterize(const Arguments& arguments) {
  const std::vector<OutputFile> files = plan_outputs(arguments.output, arguments.input);
  check_outputs(files);
  refuse_idle_output_options(arguments.choices.input.given, files);
  StopOnSignal stop;  // before the library's threads
  set_thread_count(arguments.threads);
  TerminalProgress terminal(!arguments.quiet, 0);
  terminal.report({.stage = "read"});
  Index welded = 0;
  const SourceData data = read_input(arguments.input, arguments.choices.input, false, &welded);
  const Mesh* mesh = std::get_if<Mesh>(&data.content);
  if (mesh == nullptr)
    throw InvalidInput(input_name(arguments.input) +
                       ": holds no mesh; parameterize maps meshes (.ply .obj .off .stl)");
  const Control control = terminal.control(stop.token());
  FitChoices choices = arguments.choices;
  choices.new_parameters = true;
  MappedMesh mapped;
  try {
    mapped = map_mesh(*mesh, choices, control, arguments.newton);
  } catch (const InvalidInput& e) {
    throw InvalidInput(input_name(arguments.input) + ": " + e.what());
  }
  mapped.mesh.uv = mapped.map->uv;
  for (const OutputFile& file : files) {
    if (file.kind == OutputKind::picture)
      write_text_file(file.path, arguments.output.force, picture_of(mapped, arguments, file.extension));
    else if (file.kind == OutputKind::table)
      write_text_file(file.path, arguments.output.force, vertices_csv(mapped.mesh));
    else
      write_mesh_file(file, arguments.output.force, mapped.mesh);
  }
  terminal.clear();
  if (arguments.json) {
    nlohmann::ordered_json j = nlohmann::ordered_json::parse(mesh_to_json(mapped));
    j["welded"] = welded;
    j["notes"] = data.notes;
    j["outputs"] = arguments.output.paths;
    print(j.dump() + "\n");
  } else if (!arguments.quiet) {
    std::string text = mesh_to_text(mapped);
    text += notes_to_text(reading_of(data));
    text += wrote(files);
    print(text);
  }
  return mapped.map->stopped ? kStopped : kReached;
}

}  // namespace knotfit::tool
