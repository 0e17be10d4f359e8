#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "applicable_options.h"
#include "commands.h"
#include "exit_status.h"
#include "input.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/mesh_parameters.h"
#include "outputs.h"
#include "remedy_words.h"
#include "standard_streams.h"
#include "surface_file.h"
#include "text_values.h"
#include "welding.h"
namespace knotfit::tool {
namespace {

using Json = nlohmann::ordered_json;

struct Range {
  const char* name;
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  void take(double x) {
    if (std::isnan(x)) return;
    least = std::min(least, x);
    most = std::max(most, x);
  }
  bool empty() const { return least > most; }
};

struct DataFacts {
  std::string content{}, read_as{};
  Index points = 0, holes = 0;
  std::vector<std::pair<std::string, Index>> counts{};
  std::vector<Range> ranges{};
  std::string problem{};  ///< why a mesh is no disk; empty: none
};

Range range_of(const char* name, const std::vector<double>& values) {
  Range range{name};
  for (const double x : values) range.take(x);
  return range;
}

DataFacts facts_of(const Raster& raster) {
  DataFacts facts{.content = "raster of heights", .read_as = "a height field z over x, y"};
  facts.counts = {{"columns", raster.columns}, {"rows", raster.rows}};
  Range x{"x"}, y{"y"};
  x.take(raster.x(0)), x.take(raster.x(raster.columns - 1));
  y.take(raster.y(0)), y.take(raster.y(raster.rows - 1));
  facts.ranges = {x, y, range_of("z", raster.z)};
  return facts;
}

DataFacts facts_of(const PointTable& table) {
  DataFacts facts{.content = "points"};
  const bool has_xy = !table.x.empty(), has_uv = !table.u.empty();
  if (has_xy && has_uv)
    facts.read_as = "points x, y, z with parameters u, v; with --height-field z over x, y";
  else if (has_uv)
    facts.read_as = "values z with parameters u, v";
  else
    facts.read_as = "a cloud over a base (--base); with --height-field z over x, y";
  const std::pair<const char*, const std::vector<double>*> columns[] = {
      {"x", &table.x},      {"y", &table.y},   {"z", &table.z},   {"u", &table.u},  {"v", &table.v},
      {"w", &table.weight}, {"nx", &table.nx}, {"ny", &table.ny}, {"nz", &table.nz}};
  for (const auto& [name, column] : columns)
    if (!column->empty()) facts.ranges.push_back(range_of(name, *column));
  return facts;
}

DataFacts facts_of(const PointRows& rows) {
  DataFacts facts{.content = rows.common_length() > 0 ? "grid of points" : "rows of points"};
  facts.read_as = "a surface through the rows, parameters by --spacing";
  facts.counts = {{"rows", rows.rows()}};
  if (rows.common_length() > 0) facts.counts.emplace_back("points_a_row", rows.common_length());
  facts.ranges = {{"x"}, {"y"}, {"z"}};
  for (Index k = 0; k < rows.size(); ++k)
    for (int d = 0; d < 3; ++d) facts.ranges[d].take(rows.xyz[3 * k + d]);
  return facts;
}

DataFacts facts_of(const Mesh& mesh) {
  DataFacts facts{.content = "mesh"};
  const ParameterCheck check = mesh.uv.empty() ? ParameterCheck{} : check_parameters(mesh);
  facts.read_as = mesh.uv.empty() ? "its vertices, with parameters from a map of the mesh"
                  : check.one_to_one
                      ? "its vertices at their parameters u, v, which are one-to-one; with --new-parameters "
                        "at those of a map"
                      : "its vertices, with parameters from a map of the mesh: its own (texture "
                        "coordinates) are left aside, since " +
                            check.why;
  const MeshReport report = inspect(mesh);
  try {
    require_disk(mesh);
  } catch (const InvalidInput& e) {
    facts.problem = in_tool_words(e.what()) + weld_hint(mesh);
  }
  facts.counts = {{"vertices", mesh.vertex_count()},
                  {"triangles", mesh.face_count()},
                  {"parts", report.parts},
                  {"boundary_loops", static_cast<Index>(report.loop_edges.size())},
                  {"euler_characteristic", report.euler_characteristic}};
  facts.ranges = {{"x"}, {"y"}, {"z"}};
  for (Index k = 0; k < mesh.vertex_count(); ++k)
    for (int d = 0; d < 3; ++d) facts.ranges[d].take(mesh.vertex(k)[d]);
  for (std::size_t k = 0; k < mesh.uv.size(); ++k) {
    if (k == 0) facts.ranges.insert(facts.ranges.end(), {{"u"}, {"v"}});
    facts.ranges[3 + k % 2].take(mesh.uv[k]);
  }
  return facts;
}

DataFacts facts_of(const SourceData& data) {
  DataFacts facts = std::visit([](const auto& content) { return facts_of(content); }, data.content);
  facts.holes = count_holes(data);
  facts.points = std::visit(
      [](const auto& content) {
        if constexpr (requires { content.size(); })
          return content.size();
        else if constexpr (requires { content.vertex_count(); })
          return content.vertex_count();
        else
          return static_cast<Index>(content.z.size());
      },
      data.content);
  facts.points -= facts.holes - data.left_out;  // points left out are in no table
  return facts;
}

std::string data_info(const Arguments& arguments) {
  Index welded = 0;
  const SourceData data = read_input(arguments.input, arguments.choices.input, false, &welded);
  const DataFacts facts = facts_of(data);
  const Raster* raster = std::get_if<Raster>(&data.content);
  if (arguments.json) {
    Json j = {{"kind", "data"},           {"path", data.path},      {"format", data.format},
              {"content", facts.content}, {"points", facts.points}, {"holes", facts.holes}};
    for (const auto& [name, count] : facts.counts) j[name] = count;
    if (raster) j["cell"] = {raster->dx, raster->dy};
    j["ranges"] = Json::object();
    for (const Range& r : facts.ranges)
      j["ranges"][r.name] = r.empty() ? Json(nullptr) : Json{r.least, r.most};
    if (facts.content == "mesh") {
      j["welded"] = welded;
      j["disk"] = facts.problem.empty();
      j["problem"] = facts.problem.empty() ? Json(nullptr) : Json(facts.problem);
    }
    if (!data.columns.empty()) {
      j["columns"] = data.columns;
      j["columns_from"] = data.columns_from;
    }
    j["notes"] = data.notes;
    j["read_as"] = facts.read_as;
    return j.dump() + "\n";
  }
  std::string text = fmt::format("{}: {} ({})\n", data.path, facts.content, data.format);
  for (const auto& [name, count] : facts.counts) {
    std::string shown = name;
    std::replace(shown.begin(), shown.end(), '_', ' ');
    text += fmt::format("{}: {}\n", shown, count);
  }
  text += fmt::format("points: {}\nholes: {}\n", facts.points, facts.holes);
  if (raster) text += fmt::format("cell: {} x {}\n", raster->dx, raster->dy);
  for (const Range& r : facts.ranges)
    if (!r.empty()) text += fmt::format("{}: {} to {}\n", r.name, r.least, r.most);
  text += columns_to_text(reading_of(data));
  for (const std::string& note : data.notes) text += note + "\n";
  if (facts.content == "mesh")
    text += "disk: " + (facts.problem.empty() ? "yes" : "no: " + facts.problem) + "\n";
  return text + "fitted as: " + facts.read_as + "\n";
}

// Bounds of the control net, which hold the surface (convex hull property).
std::vector<std::pair<double, double>> net_box(const Surface& surface) {
  const int d = surface.dimension();
  std::vector<std::pair<double, double>> box(d, {INFINITY, -INFINITY});
  for (std::size_t k = 0; k < surface.net().size(); ++k) {
    auto& [least, most] = box[k % d];
    least = std::min(least, surface.net()[k]);
    most = std::max(most, surface.net()[k]);
  }
  return box;
}

Json parsed(const std::string& text) {
  const Json j = Json::parse(text, nullptr, false);
  return j.is_object() ? j : Json(nullptr);
}

Json surface_json(const SurfaceDocument& document, const std::string& path) {
  const Surface& s = document.surface;
  const ParameterMap& map = document.map;
  Json j = {{"kind", "surface"},
            {"path", path},
            {"size", {s.size_u(), s.size_v()}},
            {"control_points", s.control_point_count()},
            {"degree", {s.degree_u(), s.degree_v()}},
            {"dimension", s.dimension()},
            {"height_field", document.height_field}};
  j["knots"] = {{"u", s.knots_u().knots()}, {"v", s.knots_v().knots()}};
  j["domain"] = {{map.name_u, {map.u0, map.u1}}, {map.name_v, {map.v0, map.v1}}};
  if (map.sheared()) j["shear"] = {{"u", map.shear_u}, {"v", map.shear_v}};
  j["net_bounds"] = Json::array();
  for (const auto& [least, most] : net_box(s)) j["net_bounds"].push_back({least, most});
  j["options"] = parsed(document.options);
  j["result"] = parsed(document.result);
  return j;
}

// What the file says of its making; other writers may have left parts out.
std::string making_text(const SurfaceDocument& document) {
  const Json result = parsed(document.result);
  std::string text;
  if (result.is_object()) {
    if (result.contains("input") && result["input"].contains("path"))
      text += fmt::format("fitted to: {}\n", result["input"]["path"].dump());
    if (result.contains("error") && result["error"].contains("max"))
      text += fmt::format("error: max {}, rms {}\n", result["error"]["max"].dump(),
                          result["error"].value("rms", Json()).dump());
    if (result.contains("status") && result["status"].is_string())
      text += fmt::format("status: {}: {}\n", result["status"].get<std::string>(),
                          result.value("message", std::string()));
  }
  if (!document.options.empty()) text += "options: " + parsed(document.options).dump() + "\n";
  return text;
}

std::string surface_text(const SurfaceDocument& document, const std::string& name) {
  const Surface& s = document.surface;
  const ParameterMap& map = document.map;
  std::string text = fmt::format(
      "{}: B-spline surface, {}\n", name,
      document.height_field ? "a height field z over x, y" : fmt::format("{} coordinates", s.dimension()));
  text += fmt::format("{} x {} = {} control points, degree {} x {}\n", s.size_u(), s.size_v(),
                      s.control_point_count(), s.degree_u(), s.degree_v());
  text += fmt::format("interior knots: {} along u, {} along v\n", s.knots_u().interior().size(),
                      s.knots_v().interior().size());
  text += fmt::format("domain: {} {} to {}, {} {} to {}\n", map.name_u, map.u0, map.u1, map.name_v, map.v0,
                      map.v1);
  if (map.sheared())
    text += fmt::format("oblique parameters: {} = {:.6g}\n", map.shear_u != 0 ? "shear of u" : "shear of v",
                        map.shear_u != 0 ? map.shear_u : map.shear_v);
  text += "control net:";
  for (const auto& [least, most] : net_box(s)) text += fmt::format(" [{}, {}]", least, most);
  return text + "\n" + making_text(document);
}

// Of a file with several faces: each, and why some are not usable.
std::string face_text(const FileFace& face, const std::string& path, std::size_t number) {
  const std::string name = fmt::format("{}, face {}", path, number);
  if (!face.document) return fmt::format("{}: {}, not usable: {}\n", name, face.kind, face.why);
  return surface_text(*face.document, name);
}

constexpr const char* kTrimmed =
    "trimmed: the face is a part of this surface; its borders are left out, and the surface is taken whole";

Json faces_json(const std::vector<FileFace>& faces) {
  Json j = Json::array();
  for (std::size_t k = 0; k < faces.size(); ++k)
    j.push_back({{"face", k + 1},
                 {"kind", faces[k].kind},
                 {"usable", faces[k].document.has_value()},
                 {"why_not", faces[k].document ? Json(nullptr) : Json(faces[k].why)},
                 {"trimmed", faces[k].trimmed}});
  return j;
}

std::string surfaces_info(const Arguments& arguments) {
  const bool cad = is_cad_file(arguments.input);
  std::vector<FileFace> faces;
  if (arguments.source.face)
    faces.push_back({read_one_surface(arguments.input, arguments.source), "B-spline surface", "", false});
  else
    faces = read_faces(arguments.input, arguments.source);
  const auto described = [&](const FileFace& face) {
    Json j = surface_json(*face.document, arguments.input);
    if (cad) j["unit"] = name_of(kUnits, arguments.source.unit.value_or(CadUnit::millimetre));
    if (cad) j["trimmed"] = face.trimmed;
    return j;
  };
  const bool one = faces.size() == 1 && faces[0].document;
  if (arguments.json && one) return described(faces[0]).dump() + "\n";
  if (arguments.json) {
    Json j = {{"kind", "surfaces"}, {"path", arguments.input}, {"surfaces", Json::array()}};
    for (std::size_t k = 0; k < faces.size(); ++k)
      if (faces[k].document) {
        j["surfaces"].push_back(described(faces[k]));
        j["surfaces"].back()["face"] = k + 1;
      }
    j["faces"] = faces_json(faces);
    return j.dump() + "\n";
  }
  std::string text;
  const auto usable =
      std::count_if(faces.begin(), faces.end(), [](const FileFace& f) { return f.document.has_value(); });
  if (!one)
    text = fmt::format("{}: {} face{}, {} usable\n", input_name(arguments.input), faces.size(),
                       faces.size() == 1 ? "" : "s", usable);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    text += one ? surface_text(*faces[k].document, input_name(arguments.input))
                : face_text(faces[k], arguments.input, k + 1);
    if (faces[k].document && faces[k].trimmed) text += std::string(kTrimmed) + "\n";
  }
  if (cad)
    text += fmt::format("unit: {}\n", name_of(kUnits, arguments.source.unit.value_or(CadUnit::millimetre)));
  return text;
}

}  // namespace

int run_info(const Arguments& arguments) {
  const bool surfaces = holds_surfaces(arguments.input, arguments.choices.input);
  if (surfaces) {
    refuse_data_options(arguments.choices.input.given, "a surface: it says how data is read");
    refuse_idle_surface_options(arguments.input, arguments.source);
  } else {
    refuse_given(arguments.choices.input.given, {"--unit", "--face"},
                 "data: it is for surfaces of STEP and IGES files");
  }
  print(surfaces ? surfaces_info(arguments) : data_info(arguments));
  return kReached;
}

}  // namespace knotfit::tool
