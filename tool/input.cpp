#include "input.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "applicable_options.h"
#include "cloud_input.h"
#include "data/strays.h"
#include "formats/readers.h"
#include "knotfit/exceptions.h"
#include "knotfit/parameterize.h"
#include "parameterize/table_checks.h"
#include "remedy_words.h"
#include "standard_streams.h"
#include "welding.h"
namespace knotfit::tool {
namespace {

ParameterizedPoints parameterize(const Mesh& mesh, const FitChoices& choices, const Control& control,
                                 std::optional<MappedMesh>& mapped) {
  if (choices.height_field.value_or(false)) {
    mapped = repaired_mesh(mesh, choices);
    return parameterize_height_field(table_of(mapped->mesh));
  }
  mapped = map_mesh(mesh, choices, control, true, true);
  if (mapped->map) return mesh_points(mapped->mesh, mapped->map->uv);
  try {
    return parameterize_given(table_of(mapped->mesh), choices.rescale_parameters.value_or(false));
  } catch (const InvalidInput& e) {
    throw InvalidInput(std::string(e.what()) + ", --new-parameters maps the mesh and leaves its own aside");
  }
}

/// A correction of parameters that the points came with is asked for.
bool corrected(const FitChoices& choices) {
  return choices.correct.value_or(-1) > 0;
}

/// The cloud's own parameters, if it has some, are left aside.
bool wants_base(const FitChoices& choices) {
  return choices.new_parameters.value_or(false) || choices.base.value_or("auto") != "auto";
}

/// Points of the cloud that are not among those mapped.
template <class Place>
std::vector<double> left_out_of(Index count, const std::vector<Index>& line, std::vector<Index> kept,
                                const Place& place) {
  std::sort(kept.begin(), kept.end());
  std::vector<double> out;
  for (Index k = 0; k < count; ++k)
    if (!std::binary_search(kept.begin(), kept.end(), line.empty() ? k + 1 : line[k])) {
      const std::array<double, 3> p = place(k);
      out.insert(out.end(), p.begin(), p.end());
    }
  return out;
}

ParameterizedPoints parameterize_cloud(const PointTable& table, const FitChoices& choices,
                                       const Control& control, std::optional<MappedMesh>& mapped) {
  mapped = map_cloud(table, choices, control);
  ParameterizedPoints points = mesh_points(mapped->mesh, mapped->map->uv);
  mapped->loose = left_out_of(table.size(), table.line, points.source, [&](Index k) {
    return std::array{table.x[k], table.y[k], table.z[k]};
  });
  if (table.weight.empty()) return points;
  std::vector<Index> row;  // of each line
  for (Index k = 0; k < table.size(); ++k) {
    const Index line = table.line.empty() ? k + 1 : table.line[k];
    if (line >= static_cast<Index>(row.size())) row.resize(static_cast<std::size_t>(line) + 1, 0);
    row[line] = k;
  }
  for (const Index line : points.source) points.weights.push_back(table.weight[row[line]]);
  return points;
}

ParameterizedPoints parameterize(SourceData& data, const FitChoices& choices, const Control& control,
                                 std::optional<MappedMesh>& mapped) {
  const bool height_field = choices.height_field.value_or(false);
  if (const Raster* raster = std::get_if<Raster>(&data.content)) return parameterize_height_field(*raster);
  ParameterizedPoints points;
  bool mesh = corrected(choices), in_rows = false;
  if (const PointTable* table = std::get_if<PointTable>(&data.content)) {
    if (height_field) return parameterize_height_field(*table);
    if (table->u.empty() || wants_base(choices)) return parameterize_cloud(*table, choices, control, mapped);
    points = parameterize_given(*table, choices.rescale_parameters.value_or(false));
  } else {
    const PointRows& rows = std::get<PointRows>(data.content);
    if (height_field) return parameterize_height_field(table_of(rows));
    if (choices.base.value_or("auto") != "auto")
      return parameterize_cloud(table_of(rows), choices, control, mapped);
    const RowSpacing spacing = choices.spacing.value_or(RowSpacing::chord);
    points = parameterize_rows(rows, spacing);
    // Rows of different lengths have parameters that mean little from row to row.
    const bool ragged = rows.common_length() == 0;
    mesh = mesh || (ragged && choices.correct.value_or(-1) != 0);
    in_rows = ragged && spacing == RowSpacing::chord;
  }
  const bool anew = choices.new_parameters.value_or(false);
  if ((!mesh && !anew) || points.dimension != 3) return points;
  if (corrected(choices) && !points.weights.empty())
    throw InvalidInput("--correct knows no weights of the points: leave column w out, with - in --columns");
  mapped = map_points(points, in_rows, choices, control);
  ParameterizedPoints of_mesh = mesh_points(mapped->mesh, mapped->map->uv);
  mapped->loose = left_out_of(points.size(), points.source, of_mesh.source, [&](Index k) {
    return std::array{points.value(k)[0], points.value(k)[1], points.value(k)[2]};
  });
  of_mesh.map = points.map;
  return of_mesh;
}

/// Options that say nothing of the file are refused, vertices of a mesh at the same place made one.
SourceData read_checked(const std::string& path, const ReadOptions& read, const InputOptions& options,
                        Index* welded) {
  SourceData data = read_source(path, read);
  refuse_idle_reading(data, path, options);
  const Index count = weld_input(data, options);
  if (welded != nullptr) *welded = count;
  return data;
}

/// A slip far off makes the range that a tolerance in % is of.
void note_strays(FitInput& input) {
  const ParameterizedPoints& points = input.points;
  std::vector<Index> strays = far_strays(points.values, points.dimension);
  if (strays.empty()) return;
  input.summary.reading.notes.push_back(parameterize::point_names(points.source, strays) +
                                        (strays.size() == 1 ? " stands" : " stand") +
                                        " more than 1000 times as far away as the farthest of the others: a "
                                        "stray; it makes the range that a tolerance "
                                        "in % is of, so leave it out");
}

}  // namespace

SourceData read_source(const std::string& path, const ReadOptions& options) {
  SourceData data = is_dash(path) ? read_bytes(standard_input(), options) : read_data(path, options);
  for (std::string& note : data.notes) note = in_tool_words(note);
  return data;
}

ReadOptions read_options(const InputOptions& options) {
  ReadOptions read;
  read.format = options.format.value_or("");
  read.columns = options.columns.value_or(std::vector<std::string>{});
  read.nodata = options.nodata;
  read.classes = options.classes.value_or(std::vector<int>{});
  read.returns = options.returns.value_or(std::vector<int>{});
  read.skip_lines = options.skip_lines.value_or(0);
  return read;
}

SourceData read_input(const std::string& path, const InputOptions& options, bool places, Index* welded) {
  ReadOptions read = read_options(options);
  read.places = places;
  return read_checked(path, read, options, welded);
}

Index count_holes(const SourceData& data) {
  Index holes = data.left_out;
  if (const Raster* raster = std::get_if<Raster>(&data.content)) {
    for (const double z : raster->z) holes += std::isnan(z);
  } else if (const PointRows* rows = std::get_if<PointRows>(&data.content)) {
    for (Index k = 0; k < rows->size(); ++k) holes += std::isnan(rows->xyz[3 * k + 2]);
  }
  return holes;
}

PointTable table_of(const PointRows& rows) {
  PointTable table;
  for (Index k = 0; k < rows.size(); ++k) {
    if (std::isnan(rows.xyz[3 * k + 2])) continue;
    table.x.push_back(rows.xyz[3 * k]);
    table.y.push_back(rows.xyz[3 * k + 1]);
    table.z.push_back(rows.xyz[3 * k + 2]);
    table.line.push_back(rows.line.empty() ? k + 1 : rows.line[k]);
  }
  return table;
}

PointTable table_of(const Raster& raster) {
  PointTable table;
  for (Index r = 0; r < raster.rows; ++r)
    for (Index c = 0; c < raster.columns; ++c) {
      const double z = raster.z[r * raster.columns + c];
      if (std::isnan(z)) continue;
      table.x.push_back(raster.x(c));
      table.y.push_back(raster.y(r));
      table.z.push_back(z);
    }
  return table;
}

namespace {

/// Points with equal parameters are settled as --duplicates says.
void settle(FitInput& input, const FitChoices& choices) {
  // Equal parameters make a maximum hopeless, not an RMS or a percentile: 0 lets any difference be.
  double tolerance = 0;
  if (choices.tolerance && choices.measure.value_or(MeasureValue{}).measure == ErrorMeasure::max) {
    tolerance = choices.tolerance->value;
    if (choices.tolerance->relative) tolerance *= bounding_diagonal(input.points) / 100;
  }
  const DuplicateRule rule = choices.duplicates.value_or(DuplicateRule::fail);
  ParameterizedPoints before;
  if (rule != DuplicateRule::fail) before = input.points;
  input.summary.duplicates = settle_duplicates(input.points, rule, tolerance);
  if (input.summary.duplicates > 0) input.all_points = std::move(before);
  input.summary.points = input.points.size();
}

}  // namespace

FitInput fit_input_of(SourceData data, Index welded, const FitChoices& choices, const Control& control) {
  FitInput input;
  input.summary.welded = welded;
  input.summary.reading = reading_of(data);
  input.summary.path = data.path;
  input.summary.format = data.format;
  input.summary.holes = count_holes(data);
  refuse_idle_options(data, choices);
  const Mesh* mesh = std::get_if<Mesh>(&data.content);
  input.points = mesh != nullptr ? parameterize(*mesh, choices, control, input.mesh)
                                 : parameterize(data, choices, control, input.mesh);
  if (input.mesh && !input.mesh->left_aside.empty())
    input.summary.reading.notes.push_back(
        "the mesh's parameters (texture coordinates) are left aside and the mesh is mapped, since " +
        input.mesh->left_aside);
  if (std::get_if<Raster>(&data.content) == nullptr) note_strays(input);
  settle(input, choices);
  if (Raster* raster = std::get_if<Raster>(&data.content)) input.raster = std::move(*raster);
  return input;
}

FitInput fit_input_of(ParameterizedPoints points, const std::string& name, const FitChoices& choices) {
  FitInput input;
  input.summary.path = input.summary.format = name;
  input.points = std::move(points);
  note_strays(input);
  settle(input, choices);
  return input;
}

FitInput read_fit_input(const std::string& path, const FitChoices& choices, const Control& control) {
  ReadOptions read = read_options(choices.input);
  read.any_parameters = choices.rescale_parameters.value_or(false);
  Index welded = 0;
  SourceData data = read_checked(path, read, choices.input, &welded);
  data.path = path;
  try {
    return fit_input_of(std::move(data), welded, choices, control);
  } catch (const InvalidInput& e) {
    throw InvalidInput(input_name(path) + ": " + e.what());
  }
}

}  // namespace knotfit::tool
