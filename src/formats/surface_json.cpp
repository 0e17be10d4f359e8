// Surfaces as knotfit JSON; the schema is in docs/formats.md.
#include <fmt/format.h>

#include <cmath>
#include <new>
#include <utility>

#include "formats/file_bytes.h"
#include "formats/foreign.h"
#include "formats/json_document.h"
#include "formats/number.h"
#include "formats/surface_net.h"
#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/version.h"
namespace knotfit {
namespace {

constexpr std::string_view kFormat = "knotfit-surface";
constexpr int kVersion = 1;

void append_net(std::string& out, const Surface& s) {
  out += "[\n";
  for (Index i = 0; i < s.size_u(); ++i) {
    out += "    [";
    for (Index j = 0; j < s.size_v(); ++j) {
      if (j > 0) out += ", ";
      append_numbers(out, s.control_point(i, j));
    }
    out += i + 1 < s.size_u() ? "],\n" : "]\n";
  }
  out += "  ]";
}

std::string map_objection(const ParameterMap& map) {
  if (!std::isfinite(map.u0) || !std::isfinite(map.u1) || !std::isfinite(map.v0) || !std::isfinite(map.v1))
    return "its ends must be finite";
  if (!(map.u0 < map.u1)) return fmt::format("u0 = {} must be below u1 = {}", map.u0, map.u1);
  if (!(map.v0 < map.v1)) return fmt::format("v0 = {} must be below v1 = {}", map.v0, map.v1);
  if (!(std::abs(map.shear_u) <= 1 && std::abs(map.shear_v) <= 1) || (map.shear_u != 0 && map.shear_v != 0))
    return fmt::format("shear_u = {} and shear_v = {} must be in [-1,1], one of them 0", map.shear_u,
                       map.shear_v);
  return {};
}

constexpr const char* kWhat = "knotfit surface";
using Members = JsonMembers;

std::vector<int> read_degree(const Members& in) {
  JsonReader reader = in.at("degree");
  std::vector<int> degree;
  const auto read = [&](Index k) {
    const double value = reader.number();
    if (k >= 2 || !(value >= 1 && value <= kMaxDegree) || value != std::floor(value))
      reader.fail(fmt::format("two whole numbers from 1 to {} are needed", kMaxDegree));
    degree.push_back(static_cast<int>(value));
  };
  if (reader.peek() == JsonReader::Kind::number) {  // one for both directions
    read(0);
    return {degree[0], degree[0]};
  }
  reader.array(read);
  if (degree.size() != 2) reader.fail(fmt::format("two whole numbers from 1 to {} are needed", kMaxDegree));
  return degree;
}

KnotVector read_knots(const Members& in, std::string_view name, int degree) {
  JsonReader reader = in.at(name);
  std::vector<double> knots;
  reader.array([&](Index) { knots.push_back(reader.number()); });
  try {
    return KnotVector(degree, std::move(knots));
  } catch (const InvalidInput& error) {
    in.at(name).fail(error.what());
  }
}

/// "order": "u-major" (the default) or "v-major".
bool is_v_major(const Members& in) {
  const auto order = in.find("order");
  if (!order) return false;
  JsonReader reader = in.at("order", *order);
  if (reader.peek() != JsonReader::Kind::string) reader.fail("\"u-major\" or \"v-major\" is missing");
  const std::string name = reader.string();
  if (name != "u-major" && name != "v-major")
    reader.fail(in_quotes(name) + " is neither \"u-major\" nor \"v-major\"");
  return name == "v-major";
}

ParameterMap read_map(const Members& in, std::string_view object, std::string_view text,
                      const std::string& path) {
  ParameterMap map;
  const Members members(text, object, path, kWhat);
  const auto name = [&](const char* key, std::string& out) {
    if (!members.find(key)) return;
    JsonReader reader = members.at(key);
    reader.set_member(fmt::format("parameter_map.{}", key));
    out = reader.string();
  };
  const auto number = [&](const char* key, double& out) {
    JsonReader reader = members.at(key);
    reader.set_member(fmt::format("parameter_map.{}", key));
    out = reader.number();
  };
  name("name_u", map.name_u);
  name("name_v", map.name_v);
  number("u0", map.u0);
  number("u1", map.u1);
  number("v0", map.v0);
  number("v1", map.v1);
  if (members.find("shear_u")) number("shear_u", map.shear_u);
  if (members.find("shear_v")) number("shear_v", map.shear_v);
  if (const std::string why = map_objection(map); !why.empty()) in.at("parameter_map", object).fail(why);
  return map;
}

SurfaceDocument read_document(std::string_view text, const std::string& path) {
  const Members top(text, without_mark(text), path, kWhat);
  const auto inner = top.find("surface");
  const Members in = inner ? Members(text, *inner, path, kWhat) : top;
  // Other programs' surfaces have neither.
  if (in.find("format")) check_format(in, kFormat);
  if (in.find("version")) check_version(in, kVersion);
  SurfaceDocument document;
  const std::vector<int> degree = read_degree(in);
  KnotVector knots_u = read_knots(in, "knots_u", degree[0]);
  KnotVector knots_v = read_knots(in, "knots_v", degree[1]);
  ControlNet net = read_control_net(in.at("control_points"), in.get("control_points"), knots_u.size(),
                                    knots_v.size(), is_v_major(in));
  const int dimension = net.dimension;
  try {
    document.surface = Surface(std::move(knots_u), std::move(knots_v), dimension, std::move(net.points));
  } catch (const InvalidInput& error) {
    in.at("control_points").fail(error.what());
  }
  if (const auto map = in.find("parameter_map")) document.map = read_map(in, *map, text, path);
  if (in.find("height_field")) {
    JsonReader reader = in.at("height_field");
    document.height_field = reader.boolean();
    if (document.height_field && dimension != 1)
      reader.fail(fmt::format("a height field has one component, but the control points have {}", dimension));
  }
  document.options = object_of(in, "options");
  document.result = object_of(in, "result");
  if (inner && document.options.empty()) document.options = object_of(top, "options");
  return document;
}

}  // namespace

std::string to_json(const SurfaceDocument& document) {
  const Surface& s = document.surface;
  if (s.empty()) throw InvalidInput("a surface document without a surface cannot be written");
  if (const std::string why = map_objection(document.map); !why.empty())
    throw InvalidInput("the parameter map of a surface document is wrong: " + why);
  if (document.height_field && s.dimension() != 1)
    throw InvalidInput(fmt::format("a height field has one component, not {}", s.dimension()));
  std::string out;
  out.reserve(s.net().size() * 20 + 1024);
  out += fmt::format(
      "{{\n  \"format\": \"{}\",\n  \"version\": {},\n  \"knotfit\": \"{}\",\n  \"degree\": [{}, {}],\n",
      kFormat, kVersion, version(), s.degree_u(), s.degree_v());
  out += "  \"knots_u\": ";
  append_numbers(out, s.knots_u().knots());
  out += ",\n  \"knots_v\": ";
  append_numbers(out, s.knots_v().knots());
  out += fmt::format(",\n  \"height_field\": {},\n  \"parameter_map\": {{\"name_u\": {}, ",
                     document.height_field, json_quoted(document.map.name_u));
  const auto number = [&](std::string_view name, double value, std::string_view then) {
    out += fmt::format("\"{}\": ", name);
    append_number(out, value);
    out += then;
  };
  number("u0", document.map.u0, ", ");
  number("u1", document.map.u1, ", ");
  out += fmt::format("\"name_v\": {}, ", json_quoted(document.map.name_v));
  number("v0", document.map.v0, ", ");
  number("v1", document.map.v1, "");
  if (document.map.sheared()) {
    out += ", ";
    number("shear_u", document.map.shear_u, ", ");
    number("shear_v", document.map.shear_v, "");
  }
  out += '}';
  append_object(out, "options", document.options, "surface");
  append_object(out, "result", document.result, "surface");
  out += ",\n  \"control_points\": ";
  append_net(out, s);
  out += "\n}\n";
  return out;
}

SurfaceDocument surface_from_json(std::string_view text, const std::string& path) {
  try {
    return read_document(text, path);
  } catch (const std::bad_alloc&) {
    throw FileError(path, "reading it needs more memory than there is");
  }
}

SurfaceDocument read_surface(const std::string& path) {
  const FileBytes file = load_file(path);
  refuse_foreign(file);
  return surface_from_json(file.view(), path);
}

}  // namespace knotfit
