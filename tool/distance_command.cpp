#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "applicable_options.h"
#include "base/place_text.h"
#include "commands.h"
#include "data_conversion.h"
#include "exit_status.h"
#include "input.h"
#include "knotfit/distance.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/threads.h"
#include "outputs.h"
#include "sampling.h"
#include "signals.h"
#include "standard_streams.h"
#include "surface_file.h"
#include "terminal_progress.h"
namespace knotfit::tool {
namespace {

using Json = nlohmann::ordered_json;

// x, y, z of every point, n x 3.
std::vector<double> points_of(const SourceData& data) {
  const Table table = points_table(data);
  const std::vector<double>* columns[3] = {};
  for (std::size_t c = 0; c < table.names.size(); ++c)
    for (int axis = 0; axis < 3; ++axis)
      if (table.names[c] == std::string(1, "xyz"[axis])) columns[axis] = &table.columns[c];
  for (int axis = 0; axis < 3; ++axis)
    if (columns[axis] == nullptr)
      throw InvalidInput(fmt::format(
          "{}: the points have no {}; distances are measured in space (--columns says what the columns are)",
          data.path, "xyz"[axis]));
  std::vector<double> points;
  for (std::size_t k = 0; k < columns[0]->size(); ++k)
    for (const std::vector<double>* column : columns) points.push_back((*column)[k]);
  return points;
}

double diagonal_of(const std::vector<double>& points) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = INFINITY, high = -INFINITY;
    for (std::size_t k = axis; k < points.size(); k += 3)
      low = std::min(low, points[k]), high = std::max(high, points[k]);
    sum += (high - low) * (high - low);
  }
  return std::sqrt(sum);
}

Json to_json(const DistanceSummary& s, const ParameterMap& map) {
  return {{"count", s.count},
          {"rms", s.rms},
          {"max", s.max},
          {"mean", s.mean},
          {"signed_mean", s.signed_mean},
          {"standard_deviation", s.deviation},
          {"median", s.median},
          {"p95", s.p95},
          {"p99", s.p99},
          {"p995", s.p995},
          {"worst",
           {{"index", s.worst},
            {"at", map.from_uv(s.worst_u, s.worst_v)},
            {"point", {s.worst_point[0], s.worst_point[1], s.worst_point[2]}}}}};
}

std::string to_text(const char* title, const DistanceSummary& s, const ParameterMap& map, double diagonal,
                    bool with_sign) {
  const auto [a, b] = map.from_uv(s.worst_u, s.worst_v);
  const auto shown = [&](double x) { return map.identity() ? fmt::format("{:.6g}", x) : place_text(x); };
  std::string text = fmt::format("{}: rms {:.6g}, max {:.6g} at {} = {}, {} = {}", title, s.rms, s.max,
                                 map.name_u, shown(a), map.name_v, shown(b));
  if (diagonal > 0)
    text += fmt::format("\n  of the diagonal: rms {:.4g} %, max {:.4g} %", 100 * s.rms / diagonal,
                        100 * s.max / diagonal);
  text += fmt::format("\n  mean {:.6g}, median {:.6g}, 95 % {:.6g}, 99 % {:.6g}, 99.5 % {:.6g}", s.mean,
                      s.median, s.p95, s.p99, s.p995);
  if (with_sign)
    text += fmt::format("\n  signed by the normal: mean {:.6g}, standard deviation {:.6g}", s.signed_mean,
                        s.deviation);
  return text + "\n";
}

std::vector<OutputFile> table_outputs(const Arguments& arguments) {
  std::vector<OutputFile> files = plan_outputs(arguments.output, arguments.data);
  for (const OutputFile& file : files)
    if (file.kind != OutputKind::table) throw InvalidInput(file.path + ": distance writes .csv");
  return files;
}

Table table_of_distances(const std::vector<double>& points, const PointDistances& d,
                         const ParameterMap& map) {
  Table table;
  std::vector<double> columns[6];
  for (std::size_t k = 0; k < d.signed_distances.size(); ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) columns[axis].push_back(points[3 * k + axis]);
    const auto [a, b] = map.from_uv(d.uv[2 * k], d.uv[2 * k + 1]);
    columns[3].push_back(a);
    columns[4].push_back(b);
    columns[5].push_back(d.signed_distances[k]);
  }
  const char* names[6] = {"x", "y", "z", "u", "v", "distance"};
  for (int c = 0; c < 6; ++c) table.add(names[c], std::move(columns[c]));
  return table;
}

}  // namespace

int run_distance(const Arguments& arguments) {
  const std::vector<OutputFile> files = table_outputs(arguments);
  StopOnSignal stop;  // before the library's threads
  set_thread_count(arguments.threads);
  TerminalProgress terminal(!arguments.quiet, 0);
  terminal.report({.stage = "read"});
  const Control control = terminal.control(stop.token());

  refuse_idle_surface_options(arguments.input, arguments.source);
  const SurfaceDocument document = read_one_surface(arguments.input, arguments.source);
  const Surface surface = surface_in_space(
      document, fmt::format("{}: the surface has {} coordinates; distances are of surfaces in space",
                            arguments.input, document.surface.dimension()));
  const SourceData data = read_input(arguments.data, arguments.choices.input);
  if (!std::holds_alternative<Mesh>(data.content))
    refuse_given(arguments.choices.input.given, {"--samples"},
                 "points: it is for the distance from the surface to a mesh");
  const std::vector<double> points = points_of(data);
  PointDistances distances;
  DistanceSummary back;
  const Mesh* mesh = std::get_if<Mesh>(&data.content);
  const bool both = mesh != nullptr && arguments.surface_samples > 0;
  try {
    distances = point_distances(surface, points, {}, {}, control);
    if (both && !distances.stopped)
      back = mesh_distances(surface, *mesh, {}, arguments.surface_samples, control);
  } catch (const InvalidInput& e) {
    throw InvalidInput(input_name(arguments.data) + ": " + e.what());
  }
  terminal.clear();
  if (stop.requested() || distances.stopped) return kStopped;

  const double diagonal = diagonal_of(points);
  double tolerance = 0, within = 1;
  if (arguments.choices.tolerance) {
    tolerance =
        arguments.choices.tolerance->value * (arguments.choices.tolerance->relative ? diagonal / 100 : 1);
    within = share_within(distances, tolerance);
  }
  for (const OutputFile& file : files)
    write_text_file(file.path, arguments.output.force,
                    to_csv(table_of_distances(points, distances, document.map)));
  if (arguments.json) {
    Json j = {{"surface", arguments.input},
              {"data", arguments.data},
              {"diagonal", diagonal},
              {"points_to_surface", to_json(distances.summary, document.map)},
              {"surface_to_mesh", both ? to_json(back, document.map) : Json(nullptr)},
              {"tolerance", arguments.choices.tolerance ? Json(tolerance) : Json(nullptr)},
              {"share_within", arguments.choices.tolerance ? Json(within) : Json(nullptr)},
              {"outputs", arguments.output.paths},
              {"notes", data.notes}};
    if (!data.columns.empty()) j["columns"] = data.columns, j["columns_from"] = data.columns_from;
    print(j.dump() + "\n");
  } else if (!arguments.quiet) {
    const Reading reading = reading_of(data);
    std::string text = columns_to_text(reading);
    text += to_text(fmt::format("{} points to the surface", distances.summary.count).c_str(),
                    distances.summary, document.map, diagonal, true);
    if (both)
      text += to_text(fmt::format("surface to the mesh, from {} samples", back.count).c_str(), back,
                      document.map, diagonal, false);
    if (arguments.choices.tolerance)
      text += fmt::format("within {:.6g}: {:.6g} % of the points\n", tolerance, 100 * within);
    text += notes_to_text(reading);
    text += wrote(files);
    print(text);
  }
  return within < 1 ? kNotReached : kReached;
}

}  // namespace knotfit::tool
