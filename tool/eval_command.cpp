#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "applicable_options.h"
#include "commands.h"
#include "exit_status.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/fit_least_squares.h"
#include "knotfit/io.h"
#include "knotfit/threads.h"
#include "outputs.h"
#include "places.h"
#include "sampling.h"
#include "surface_file.h"
namespace knotfit::tool {
namespace {

using Json = nlohmann::ordered_json;

// How far the surface is from the points given: |S - P|.
struct Differences {
  std::vector<double> errors;
  ErrorSummary summary;
};

Differences add_differences(Table& table, const Places& places, const std::vector<double>& uv,
                            const Surface& surface) {
  const int d = places.given_dimension;
  const std::vector<double> values = evaluate(surface, uv);
  Differences differences;
  differences.errors.resize(places.a.size());
  std::vector<double> shown(places.a.size());
  for (Index k = 0; k < places.size(); ++k) {
    double squared = 0;
    for (int c = 0; c < d; ++c) squared += std::pow(values[k * d + c] - places.given[k * d + c], 2);
    differences.errors[k] = std::sqrt(squared);
    shown[k] = d == 1 ? values[k] - places.given[k] : differences.errors[k];
  }
  const std::vector<std::string> components = component_names(d);
  for (int c = 0; c < d; ++c) {
    std::vector<double> column(places.a.size());
    for (Index k = 0; k < places.size(); ++k) column[k] = places.given[k * d + c];
    table.add(components[c] + "_given", std::move(column));
  }
  table.add(d == 1 ? "difference" : "error", std::move(shown));
  ParameterizedPoints points;
  points.dimension = d;
  points.uv = uv;
  points.values = places.given;
  differences.summary = summarize_errors(differences.errors, points);
  return differences;
}

std::string worst_text(const Places& places, const ErrorSummary& e, const ParameterMap& map) {
  const std::string line =
      places.line.empty() ? std::string() : fmt::format("line {}, ", places.line[e.worst]);
  return fmt::format("{}{} = {}, {} = {}", line, map.name_u, places.a[e.worst], map.name_v,
                     places.b[e.worst]);
}

// `prefix` makes comments of the lines where a table goes before them.
std::string differences_text(const Places& places, const ErrorSummary& e, const ParameterMap& map,
                             const std::string& prefix) {
  return fmt::format(
      "{0}{1} points: difference rms {2:.6g}, max {3:.6g} at {4}\n"
      "{0}mean {5:.6g}, median {6:.6g}, 95 % {7:.6g}, 99 % {8:.6g}, 99.5 % {9:.6g}\n",
      prefix, places.size(), e.rms, e.max, worst_text(places, e, map), e.mean, e.median, e.p95, e.p99,
      e.p995);
}

Json differences_json(const Places& places, const ErrorSummary& e) {
  Json worst = {{"index", e.worst},
                {"line", places.line.empty() ? Json(nullptr) : Json(places.line[e.worst])},
                {"at", {places.a[e.worst], places.b[e.worst]}}};
  return {{"points", places.size()},  {"rms", e.rms}, {"max", e.max}, {"mean", e.mean},
          {"median", e.median},       {"p95", e.p95}, {"p99", e.p99}, {"p995", e.p995},
          {"worst", std::move(worst)}};
}

std::vector<IntegerPair> wanted_derivatives(const Arguments& arguments) {
  std::vector<IntegerPair> orders = arguments.derivatives;
  for (int total = 1; total <= arguments.derivatives_up_to.value_or(0); ++total)
    for (int b = 0; b <= total; ++b) orders.push_back({total - b, b});
  return orders;
}

std::vector<OutputFile> table_outputs(const Arguments& arguments) {
  std::vector<OutputFile> files = plan_outputs(arguments.output, arguments.input);
  for (const OutputFile& file : files)
    if (file.kind != OutputKind::table)
      throw InvalidInput(file.path + ": eval writes .csv; knotfit convert writes other formats");
  return files;
}

}  // namespace

int run_eval(const Arguments& arguments) {
  set_thread_count(arguments.threads);
  const std::vector<OutputFile> files = table_outputs(arguments);
  refuse_idle_surface_options(arguments.input, arguments.source);
  if (arguments.points.empty()) {
    const std::string what = "places without a file: it says how --points is read";
    refuse_data_options(arguments.choices.input.given, what);
    refuse_given(arguments.choices.input.given, {"--input-format"}, what);
  }
  const SurfaceDocument document = read_one_surface(arguments.input, arguments.source);
  const Places places = find_places(arguments, document);
  const std::vector<double> uv = parameters_of(places, document.map, arguments.clamp);

  Table table = sample(document, places, uv,
                       {.derivatives = wanted_derivatives(arguments),
                        .normals = arguments.normals,
                        .curvature = arguments.curvature});
  const bool compares = places.given_dimension > 0 && places.given_dimension == document.surface.dimension();
  Differences differences;
  if (compares) differences = add_differences(table, places, uv, document.surface);

  for (const OutputFile& file : files) write_text_file(file.path, arguments.output.force, to_csv(table));
  if (arguments.json) {
    Json j = {{"columns", table.names}, {"rows", Json::array()}};
    for (Index k = 0; k < places.size(); ++k) {
      Json row = Json::array();
      for (const std::vector<double>& column : table.columns) row.push_back(column[k]);
      j["rows"].push_back(std::move(row));
    }
    j["differences"] = compares ? differences_json(places, differences.summary) : Json(nullptr);
    print(j.dump() + "\n");
    return kReached;
  }
  std::string text = files.empty() ? to_csv(table) : std::string();
  if (compares)
    text += differences_text(places, differences.summary, document.map, files.empty() ? "# " : "");
  text += wrote(files);
  print(text);
  return kReached;
}

}  // namespace knotfit::tool
