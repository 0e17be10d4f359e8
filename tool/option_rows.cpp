#include "option_rows.h"

#include <algorithm>

#include "text_values.h"
namespace knotfit::tool {
namespace {

// --no-NAME of every switch that is stored.
void add_undoing_rows(std::vector<OptionRow>& rows) {
  const std::size_t count = rows.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (rows[k].stored.form != Form::boolean) continue;
    const std::string name = rows[k].name();
    rows.push_back(
        {.names = "--no-" + name.substr(2),
         .uses = {{kFit, "Repeating a fit", "Undo a stored " + name}},
         .holds = {[take = rows[k].holds.take](Arguments& a, const std::string&) { take(a, "off"); }},
         .excludes = {name}});
  }
}

std::vector<OptionRow> all_rows() {
  std::vector<OptionRow> rows;
  add_size_rows(rows);
  add_input_rows(rows);
  add_output_rows(rows);
  add_mesh_rows(rows);
  add_look_rows(rows);
  add_undoing_rows(rows);
  return rows;
}

}  // namespace

std::span<const CommandRow> command_rows() {
  const std::string data = "Points with parameters, a mesh, a raster of heights, rows or grids of points";
  const std::string surface = "A surface.json, or a STEP or IGES file";
  static const std::vector<CommandRow> rows = {
      {Command::fit, "fit", "Fit one B-spline surface to points, a mesh or terrain", {{"INPUT", data}}},
      {Command::compare,
       "compare",
       "Every placement method on the same data: a table and pictures",
       {{"INPUT", data}}},
      {Command::fit_curve,
       "fit-curve",
       "Fit one B-spline curve to ordered points",
       {{"INPUT",
         "Ordered points: x,y or x,y,z on each line (airfoils of Selig's or Lednicer's form too), an n x 2 "
         "or n x 3 array, "
         "or one row of points"}}},
      {Command::parameterize,
       "parameterize",
       "Give the vertices of a mesh parameters u, v",
       {{"MESH", "A mesh with one boundary loop: .ply .obj .off .stl"}}},
      {Command::eval,
       "eval",
       "Values, derivatives and differences of a surface",
       {{"SURFACE", surface, true}}},
      {Command::distance,
       "distance",
       "Distances between a surface and points or a mesh",
       {{"SURFACE", surface, true}, {"DATA", "Points, a mesh, a raster of heights, rows of points"}}},
      {Command::info,
       "info",
       "What a surface or a data file holds",
       {{"FILE", "A surface.json, a STEP or IGES file, or a data file"}}},
      {Command::convert,
       "convert",
       "Write a surface or data in another format",
       {{"INPUT", "A surface.json, a STEP or IGES file, or a data file"}}},
      {Command::methods, "methods", "List the knot placement methods", {}},
      {Command::formats, "formats", "List the file formats", {}}};
  return rows;
}

const Use* OptionRow::use_of(Command command) const {
  for (const Use& use : uses)
    if ((use.commands & only(command)) != 0) return &use;
  return nullptr;
}

Commands OptionRow::commands() const {
  Commands all = 0;
  for (const Use& use : uses) all |= use.commands;
  return all;
}

std::vector<std::string> OptionRow::all_names() const {
  const std::vector<std::string_view> all = split(names, ',');
  return {all.begin(), all.end()};
}

std::string OptionRow::name() const {
  for (const std::string& one : all_names())
    if (one.starts_with("--")) return one;
  return names;
}

std::string OptionRow::key() const {
  if (!stored.key.empty()) return stored.key;
  std::string key = name().substr(2);
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

std::span<const OptionRow> option_rows() {
  static const std::vector<OptionRow> rows = all_rows();
  return rows;
}

std::vector<const OptionRow*> rows_of(Command command) {
  std::vector<const OptionRow*> rows;
  for (const std::string_view group : kGroups)
    for (const OptionRow& row : option_rows()) {
      const Use* use = row.use_of(command);
      if (use != nullptr && use->group == group) rows.push_back(&row);
    }
  return rows;
}

}  // namespace knotfit::tool
